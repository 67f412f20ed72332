import { existsSync, readdirSync } from 'node:fs';
import { defineConfig } from 'vite';

/** Address of the real Sponza, if its glTF was put into public/models/Sponza (which git ignores), else null. */
function sponzaUrl(): string | null {
  const folder = new URL('../../public/models/Sponza/', import.meta.url);
  if (!existsSync(folder)) return null;
  const names = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) =>
    /\.(gltf|glb)$/i.test(name),
  );
  const [shortest] = names.sort((a, b) => a.length - b.length);
  return shortest === undefined ? null : `./models/Sponza/${encodeURI(shortest.replaceAll('\\', '/'))}`;
}

export default defineConfig({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  define: { SPONZA_URL: JSON.stringify(sponzaUrl()) },
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
