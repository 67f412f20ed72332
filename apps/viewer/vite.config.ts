import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  resolve: { dedupe: ['three'] },
  // What is imported late must be known early, or the development server reloads the page when a model asks for it.
  optimizeDeps: {
    include: [
      'three/addons/controls/OrbitControls.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'three/addons/loaders/DRACOLoader.js',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/loaders/KTX2Loader.js',
    ],
  },
  build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
});
