import type { SeriesChoice } from '../../plan/Configuration';
import type { Axis } from '../../plan/LabPlan';
import { axisWords, sceneWords } from '../../plan/sceneWords';
import { Select } from '../Select';
import { NumberField } from './NumberField';
import { ValuesField } from './ValuesField';

interface SeriesFieldsProps {
  series: SeriesChoice;
  /** Position among the series, from 1. */
  number: number;
  /** Name of the scene that was handed over; null for none. */
  ownScene: string | null;
  onChange(series: SeriesChoice): void;
  /** Takes the series away; absent for the only one. */
  onRemove?(): void;
}

const valueHints: Record<Axis, string> = {
  lights: 'Numbers of lights, as in 10, 100, 1000.',
  objects: 'Numbers of planes; each becomes the next square: 100 is 10 × 10.',
  pixels: 'Thousands of pixels, as in 230, 922, 2074; the picture keeps its shape.',
  overdraw: 'Layers of quads, one behind the other, as in 1, 4, 16.',
  shadows: 'How many of the lights cast shadows, as in 0, 4, 16.',
};

/** One chart's cases: a scene, what changes, and its values. */
export function SeriesFields({ series, number, ownScene, onChange, onRemove }: SeriesFieldsProps) {
  const words = sceneWords[series.scene];
  const isPlanes = series.scene === 'benchmarkLights';
  const change = (changes: Partial<SeriesChoice>): void => onChange({ ...series, ...changes });
  const chooseScene = (scene: string): void => {
    const { axes } = sceneWords[scene];
    if (axes.includes(series.axis)) change({ scene });
    else change({ scene, ...startOf(axes[0]) });
  };
  const scenes = Object.entries(sceneWords).filter(([name]) => name !== 'own' || ownScene !== null);
  return (
    <fieldset class="series">
      <legend>Chart {number}</legend>
      {onRemove && (
        <button type="button" class="quiet remove" onClick={onRemove} aria-label={`Remove chart ${number}`}>
          Remove
        </button>
      )}
      <div class="fields">
        <Select
          label="Scene"
          value={series.scene}
          options={scenes.map(([name, { label }]) => [name, name === 'own' ? (ownScene ?? label) : label])}
          onChange={chooseScene}
        />
        <Select
          label="What changes"
          value={series.axis}
          options={words.axes.map((axis) => [axis, axisWords[axis].label])}
          onChange={(axis) => change(startOf(axis as Axis))}
        />
        <p class="hint wide">{words.help}</p>
        <ValuesField
          label={`Values: ${axisWords[series.axis].unit}${series.axis === 'pixels' ? ', in thousands' : ''}`}
          values={series.values}
          hint={valueHints[series.axis]}
          onChange={(values) => change({ values })}
        />
        {isPlanes && series.axis !== 'objects' && (
          <NumberField label="Planes along a side" value={series.n} min={1} max={100} onChange={(n) => change({ n })} />
        )}
        {series.axis !== 'lights' && series.scene !== 'own' && (
          <NumberField
            label="Lights"
            value={series.lights === 'objects' ? 100 : series.lights}
            min={0}
            max={20_000}
            isDisabled={series.lights === 'objects'}
            onChange={(lights) => change({ lights })}
          />
        )}
        {series.axis === 'objects' && (
          <label class="check wide">
            <input
              type="checkbox"
              checked={series.lights === 'objects'}
              onChange={({ currentTarget }) => change({ lights: currentTarget.checked ? 'objects' : 100 })}
            />
            As many lights as planes
          </label>
        )}
      </div>
    </fieldset>
  );
}

/** An axis with values to begin with. */
function startOf(axis: Axis): Pick<SeriesChoice, 'axis' | 'values' | 'lights'> {
  const values: Record<Axis, number[]> = {
    lights: [10, 100, 1000],
    objects: [1, 25, 100, 400],
    pixels: [230, 922, 2074],
    overdraw: [1, 2, 4, 8],
    shadows: [0, 1, 4, 16],
  };
  return { axis, values: values[axis], lights: axis === 'lights' ? 0 : axis === 'shadows' ? 64 : 100 };
}
