import { builtinModules } from 'node:module';
import { defineConfig, mergeConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';
import { leftToHost, readManifest } from '../tools/publishedPackages.mjs';

const isOfHost = leftToHost(readManifest(import.meta.dirname));

/** The published bundle, for Node: dependencies and Node's own modules are left to the host. */
export default defineConfig(
  mergeConfig(libraryConfig(new URL('.', import.meta.url)), {
    build: {
      ssr: true,
      rolldownOptions: {
        external: (id: string) => id.startsWith('node:') || builtinModules.includes(id) || isOfHost(id),
      },
    },
  }),
);
