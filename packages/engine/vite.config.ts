import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/**
 * The published package: a file for each module, so that an app loads code of its first frame alone; three and the
 * renderer are left to the host.
 */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' }),
);
