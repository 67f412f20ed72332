import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published package: a file for each module, so that an app loads what its first frame needs alone; three is left to the host. */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' }),
);
