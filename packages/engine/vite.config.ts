import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';
import { runModule } from '../tools/valueModules.mjs';

/** Writes the schema of scene files, which is made of the tables of fields, beside the entries. */
const schema: Plugin = {
  name: 'farol:scene-schema',
  async generateBundle() {
    const { sceneSchema } = await runModule(fileURLToPath(new URL('src/files/sceneSchema.ts', import.meta.url)));
    this.emitFile({ type: 'asset', fileName: 'scene.schema.json', source: `${JSON.stringify(sceneSchema())}\n` });
  },
};

/**
 * The published package: a file for each module, so that an app loads code of its first frame alone; three and the
 * renderer are left to the host.
 */
const config = libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' });
export default defineConfig({ ...config, plugins: [config.plugins, schema] });
