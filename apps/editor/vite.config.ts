import react from '@vitejs/plugin-react';
import { appAddresses } from '@farol/tools/appAddresses';
import { offlineApp } from '@farol/tools/offlineApp';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { scriptDeclarations } from '@farol/tools/scriptDeclarations';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { wholeThree } from '@farol/tools/wholeThree';
import { defineConfig } from 'vite';
import { playerPlugin } from './player.config.ts';

/** Files of the first frame, which are loaded when late code imports them. */
const initial = /^assets\/(index|three|rolldown-runtime)-/;

/** Modules of the engine that are only needed to open files; those that the first scene needs are excepted. */
const openingFiles = [
  /^files\/(?!(preloadFileCode|serialize|assetUses|FarolFile|restoreComponent|readComponent|ProblemList|FilePath)\.)\w+\.js$/,
  /^guard\/(checkDepth|checkModel|signature|unpack|exr\/readExrHeader|pictures\/(imageSize|pictureMemory)|zip\/\w+)\.js$/,
  /^assets\/(memory|lightExtras|collectFiles|makeKTX2Loader)\.js$/,
];

/** Whether a module, by its path, only serves to open files. */
function opensFiles(id: string): boolean {
  const [, path] = id.replaceAll('\\', '/').split('/engine/dist/chunks/');
  return path !== undefined && openingFiles.some((each) => each.test(path));
}

/**
 * Files to fetch at once with a file that is imported late: its imports that are not loaded yet. The file itself is
 * requested a moment later anyway; it is included only when it has styles, which are awaited first.
 */
function resolveDependencies(
  file: string,
  dependencies: string[],
  { hostType }: { hostType: 'html' | 'js' },
): string[] {
  if (hostType === 'html') return dependencies;
  const late = dependencies.filter((each) => each !== file && !initial.test(each));
  return late.some((each) => each.endsWith('.css')) ? [file, ...late] : late;
}

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: '../../public',
  plugins: [
    react(),
    wholeThree(),
    playerPlugin(),
    scriptDeclarations(),
    securePages({ runsScripts: true }),
    appAddresses(),
    offlineApp({ name: 'Farol editor', opens: '.farol' }),
  ],
  server: { port: 5173, strictPort: true },
  // dynamically imported packages must be listed, or the development server reloads the page when one is first needed
  optimizeDeps: {
    include: [
      'three/addons/controls/OrbitControls.js',
      'three/addons/exporters/GLTFExporter.js',
      'three/addons/libs/fflate.module.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'three/addons/loaders/DRACOLoader.js',
      'three/addons/lights/RectAreaLightTexturesLib.js',
      'three/addons/loaders/EXRLoader.js',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/loaders/KTX2Loader.js',
      'three/addons/loaders/MTLLoader.js',
      'three/addons/loaders/STLLoader.js',
      'three/addons/loaders/TGALoader.js',
      'three/addons/math/MeshSurfaceSampler.js',
      'mediabunny',
      'postprocessing',
      '@farol/bake > three-mesh-bvh',
      'typescript-in-browser',
      'xatlas-wasm',
      'zod',
    ],
  },
  resolve: {
    dedupe: ['three', 'react', 'react-dom'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 2000,
    // every supported browser preloads modules by itself, except Safari 16, which works without
    modulePreload: { polyfill: false, resolveDependencies },
    rolldownOptions: {
      // three has hundreds of constants; an inlined one compresses better than a variable
      optimization: { inlineConst: { mode: 'all', pass: 3 } },
      output: {
        // the first frame's code is in few files, which compress better and are requested at once
        codeSplitting: {
          groups: [
            { name: 'three', tags: ['$initial'], test: /[\\/]node_modules[\\/]three[\\/]/, priority: 4 },
            {
              name: 'microShaderSources',
              test: /microShaderSources/,
              priority: 5,
              includeDependenciesRecursively: false,
            },
            // code that reads models: the engine's index imports it too, but only opened files need it
            {
              name: 'models',
              test: /[\\/]engine[\\/]dist[\\/]chunks[\\/](guard[\\/]gltf[\\/]|assets[\\/]readModel|files[\\/]packGltf)/,
              priority: 5,
              includeDependenciesRecursively: false,
            },
            // code that opens files: the engine's index imports it beside code that the first scene needs
            {
              name: 'files',
              test: opensFiles,
              priority: 4,
              includeDependenciesRecursively: false,
            },
            { name: 'initial', tags: ['$initial'], priority: 3 },
            // panels open at first, in two files: requesting seventy small files takes longer than reading them
            { name: 'viewport-panel', test: /[\\/](ViewportPanel|Toolbar)\.tsx$/, priority: 2 },
            { name: 'panels', test: /[\\/](Hierarchy|Inspector|Assets)Panel\.tsx$/, priority: 1 },
          ],
        },
      },
    },
  },
}));
