import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/**
 * The published bundle: a file for each module, so that what an app does not need at first comes later; three and the
 * renderer are left to the host.
 */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), {
    preserveModules: true,
    preserveModulesRoot: 'src',
  }),
);
