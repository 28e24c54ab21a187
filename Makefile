# For those who have make: the same as make.sh, which needs nothing that a minimal Debian lacks.
.PHONY: report test build
report test build:
	./make.sh $@
