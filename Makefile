# For those who have make: the same as make.sh, which needs nothing that a minimal Debian lacks.
.PHONY: report test build bench gallery deb builds
report test build bench gallery deb builds:
	./make.sh $@
