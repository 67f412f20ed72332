import { fileURLToPath } from 'node:url';
import { isWhole } from '@farol/tools/extent';
import { smallPlot } from '@farol/tools/smallPlot';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { build, type Rolldown } from 'vite';
import { expect, test } from 'vitest';
import { drawSamples } from './drawSamples';

test('Observable Plot as it is built draws what the whole of it draws, in fewer bytes', async () => {
  const small = await bundle(true);
  expect(small.length).toBeLessThan(262_000);
  if (isWhole) expect(small.length).toBeLessThan((await bundle(false)).length - 70_000);
  const built = (await import(`data:text/javascript,${encodeURIComponent(small)}`)) as { drawSamples(): string[] };
  expect(built.drawSamples()).toEqual(drawSamples());
});

/** The drawing of charts as one module. */
async function bundle(isSmall: boolean): Promise<string> {
  const input = fileURLToPath(new URL('drawSamples.ts', import.meta.url));
  const result = (await build({
    ...{ configFile: false, logLevel: 'silent', plugins: isSmall ? [smallPlot()] : [] },
    resolve: { conditions: sourceConditions }, // a fresh clone has not built the packages yet
    build: { write: false, minify: true, rolldownOptions: { input, preserveEntrySignatures: 'strict' } },
  })) as Rolldown.RolldownOutput;
  return result.output[0].code;
}
