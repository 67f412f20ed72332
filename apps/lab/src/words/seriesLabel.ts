import { t, textLanguage } from '@farol/editing';
import type { LabSeries } from '../plan/LabPlan';
import { lightKinds, shadings } from '../plan/lightKinds';
import { axisLabel, sceneWords } from '../plan/sceneWords';
import { formatNumber } from './format';

/** Label of a series in the page's language: `Atrium over point lights, 100 lights`. Runs keep the English one. */
export function seriesLabel(series: LabSeries): string {
  if (textLanguage() === 'en') return series.label;
  const axis = axisLabel(series).toLowerCase();
  return t('{scene} over {axis}', { scene: sceneOf(series), axis }) + lightsOf(series);
}

/** Label of a series without its axis: `Atrium` for `Atrium over point lights`. */
export function seriesWord(series: LabSeries): string {
  if (textLanguage() === 'en') return series.label.replace(/ over [^,]*/, '');
  return sceneOf(series) + lightsOf(series);
}

/** Scene, with planes, kind of lights, range and shading unless these are the defaults or differ between cases. */
function sceneOf({ axis, cases, label }: LabSeries): string {
  const { scene, lightKind, lightRange, shading } = cases[0];
  if (!Object.hasOwn(sceneWords, scene.name)) return label;
  const { n } = scene.parameters;
  const planes = axis === 'objects' || n === undefined ? '' : ` ${n} × ${n}`;
  const parts = [
    axis === 'kind' || lightKind === 'points' ? '' : t(lightKinds[lightKind].word),
    lightRange === null ? '' : t('reach {range} m', { range: lightRange }),
    axis === 'shading' || shading === 'own' ? '' : t(shadings[shading].word),
  ].filter(Boolean);
  return `${t(sceneWords[scene.name].label)}${planes}${parts.length > 0 ? ` (${parts.join('; ')})` : ''}`;
}

/** Number of lights, unless it is the axis. */
function lightsOf({ axis, cases }: LabSeries): string {
  const [{ lights }] = cases;
  if (axis === 'lights' || lights === null) return '';
  const isFixed = cases.every((each) => each.lights === lights);
  return `, ${isFixed ? t('{count} lights', { count: formatNumber(lights, 6) }) : t('as many lights as planes')}`;
}
