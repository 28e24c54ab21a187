# For those who have make: the same as make.sh, which needs nothing that a minimal Debian lacks.
.PHONY: report test build bench
report test build bench:
	./make.sh $@
