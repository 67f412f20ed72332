import { appAddresses } from '@farol/tools/appAddresses';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { labBuild } from '@farol/tools/labBuild';
import { runInfo } from '@farol/tools/runInfo';
import { rivals } from '@farol/tools/rivalsPlugin';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { valueModules } from '@farol/tools/valueModules';
import { defineConfig } from 'vite';

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: false,
  define: labBuild(),
  plugins: [
    runInfo(),
    securePages(),
    rivals(),
    appAddresses(),
    valueModules('/lab/src/competitors/competitorNames.ts'),
  ],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  resolve: {
    dedupe: ['three'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  // late imports are listed: otherwise the development server reloads the page when a scene needs one
  optimizeDeps: {
    entries: ['index.html', 'stage.html'],
    include: [
      'three/addons/libs/fflate.module.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'three/addons/loaders/DRACOLoader.js',
      'three/addons/loaders/EXRLoader.js',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/loaders/KTX2Loader.js',
      'three/webgpu',
    ],
  },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 2000,
    rolldownOptions: { input: ['index.html', 'stage.html'] },
  },
}));
