import { appAddresses } from '@farol/tools/appAddresses';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { labBuild } from '@farol/tools/labBuild';
import { runInfo } from '@farol/tools/runInfo';
import { rivals } from '@farol/tools/rivalsPlugin';
import { smallPlot } from '@farol/tools/smallPlot';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { stanfordDragon } from '@farol/tools/stanfordDragon';
import { defineConfig } from 'vite';

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: false,
  define: labBuild(),
  assetsInclude: ['**/*.ply.gz'],
  plugins: [stanfordDragon(), runInfo(), securePages(), rivals(), appAddresses(), smallPlot()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  resolve: {
    dedupe: ['three'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  optimizeDeps: { entries: ['index.html', 'stage.html'], include: ['three/webgpu'] },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 2000,
    rolldownOptions: { input: ['index.html', 'stage.html'] },
  },
}));
