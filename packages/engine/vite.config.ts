import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';
import { runModule } from '../tools/valueModules.mjs';

/** Writes the JSON schema of scene files, made from the field tables, next to the entries. */
const schema: Plugin = {
  name: 'farol:scene-schema',
  async generateBundle() {
    const { sceneSchema } = await runModule(fileURLToPath(new URL('src/files/sceneSchema.ts', import.meta.url)));
    this.emitFile({ type: 'asset', fileName: 'scene.schema.json', source: `${JSON.stringify(sceneSchema())}\n` });
  },
};

/**
 * The published package: one file per module, so that an app loads only the code of its first frame; three and the
 * renderer are peer dependencies.
 */
const config = libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' });
export default defineConfig({ ...config, plugins: [config.plugins, schema] });
