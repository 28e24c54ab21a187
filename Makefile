# For those who have make: the same as make.sh, which needs nothing that a minimal Debian lacks.
.PHONY: report test build bench gallery builds
report test build bench gallery builds:
	./make.sh $@
