import { appAddresses } from '@farol/tools/appAddresses';
import { offlineApp } from '@farol/tools/offlineApp';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { defineConfig } from 'vite';

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: '../../public',
  plugins: [securePages(), appAddresses(), offlineApp({ name: 'Farol viewer' })],
  resolve: {
    dedupe: ['three'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  // late imports: if they are not listed, the development server reloads the page when a model needs one
  optimizeDeps: {
    entries: ['index.html'],
    include: [
      'three/addons/controls/OrbitControls.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'three/addons/loaders/DRACOLoader.js',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/loaders/KTX2Loader.js',
      'three/addons/loaders/MTLLoader.js',
      'three/addons/loaders/PLYLoader.js',
      'three/addons/loaders/STLLoader.js',
      'three/addons/loaders/TGALoader.js',
    ],
  },
  build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
}));
