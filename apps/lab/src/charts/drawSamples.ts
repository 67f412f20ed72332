import { chartSVG } from './chartSVG';
import { defaultSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { sampleRun } from './sampleRuns';

/** Files of the charts of made-up runs, for tests. */
export function drawSamples(): string[] {
  const [run, other] = [sampleRun({ preset: 'thesis' }), sampleRun({ preset: 'thesis', seed: 2, slowness: 2 })];
  return [
    ...chartsOf([run, other], defaultSettings),
    ...chartsOf([sampleRun({ preset: 'shadows' })], { ...defaultSettings, scale: 'linear' }),
  ].map((chart) => chartSVG(chart));
}
