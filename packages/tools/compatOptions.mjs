/** The last release of each minor of three that the packages' `peerDependencies` allow, and the last of its types. */
export const typesOfThree = {
  '0.183.2': '0.183.1',
  '0.184.0': '0.184.1',
  '0.185.1': '0.185.4',
  '0.186.1': '0.186.0',
  '0.187.0': '0.187.0',
};

export const threeVersions = Object.keys(typesOfThree);

export const compatHelp = `npm run compat -- [options] [versions of three, default ${threeVersions.join(' ')}]

Draws the agreement matrix with each version of three against that three's own renderer, by one build of the packages,
compiles the packages' declarations and samples with its types, and prints a table. Each version is installed into .cache/compat.

  --all             all browser tests of pictures, not the matrix and the agreement suites alone
  --only TEXT       the tests whose title matches this regular expression
  --workers N       browsers side by side; default the number of cores, at most 10
  --gpu             take the GPU of this machine, not the software rasteriser
  --built           take the packages as they were last built
  --help            this text`;

/** Options in the form of util.parseArgs. */
export const compatOptions = /** @type {const} */ ({
  all: { type: 'boolean' },
  only: { type: 'string' },
  workers: { type: 'string' },
  gpu: { type: 'boolean' },
  built: { type: 'boolean' },
  help: { type: 'boolean' },
});
