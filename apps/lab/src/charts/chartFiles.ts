import type { LabRun } from '../results/LabRun';
import { chartSVG } from './chartSVG';
import { type ChartSpec, defaultSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { sourceOf } from './runNames';

export interface ChartFile {
  /** File name in lower kebab case, without extension. */
  readonly name: string;
  readonly svg: string;
}

/** All charts of a run as files; one for each option of a choice with `exportsAll`. Needs no browser. */
export function chartFiles(run: LabRun): ChartFile[] {
  return chartsOf([run], defaultSettings).flatMap(({ key, choice, ...chart }) => {
    const source = sourceOf([run]);
    if (!choice?.exportsAll) return { name: key, svg: chartSVG({ ...chart, key, choice }, { source }) };
    return choice.options.map((option, i) => {
      const settings = { ...defaultSettings, cases: { [key]: i } };
      const chosen: ChartSpec = chartsOf([run], settings).find((each) => each.key === key)!;
      const name = `${key}-${option.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-')}`;
      return { name, svg: chartSVG(chosen, { source }) };
    });
  });
}
