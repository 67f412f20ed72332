import { t } from '@farol/editing';
import type { SeriesChoice } from '../../plan/Configuration';
import { type Axis, isNamed } from '../../plan/LabPlan';
import {
  type LightKind,
  lightKindNames,
  lightKinds,
  type Shading,
  shadingNames,
  shadings,
} from '../../plan/lightKinds';
import { axisWords, sceneWords } from '../../plan/sceneWords';
import { Select } from '../Select';
import { NamesField } from './NamesField';
import { NumberField } from './NumberField';
import { ValuesField } from './ValuesField';

interface SeriesFieldsProps {
  series: SeriesChoice;
  /** Position among the series, from 1. */
  number: number;
  /** Name of the handed-over scene; null for none. */
  ownScene: string | null;
  onChange(series: SeriesChoice): void;
  /** Removes the series; absent for the only one. */
  onRemove?(): void;
}

const valueHints: Record<Exclude<Axis, 'kind' | 'shading'>, string> = {
  lights: 'Numbers of lights, as in 10, 100, 1000.',
  objects: 'Numbers of planes; each becomes the next square: 100 is 10 × 10.',
  pixels: 'Thousands of pixels, as in 230, 922, 2074; the picture keeps its shape.',
  overdraw: 'Layers of quads, one behind the other, as in 1, 4, 16.',
  shadows: 'How many of the lights cast shadows, as in 0, 4, 16.',
};

/** Settings of a series: scene, axis and values. */
export function SeriesFields({ series, number, ownScene, onChange, onRemove }: SeriesFieldsProps) {
  const words = sceneWords[series.scene];
  const isPlanes = series.scene === 'benchmarkLights';
  const change = (changes: Partial<SeriesChoice>): void => onChange({ ...series, ...changes });
  const chooseScene = (scene: string): void => {
    const { axes } = sceneWords[scene];
    const reset = scene === 'own' ? { lightKind: undefined, lightRange: undefined } : {};
    if (axes.includes(series.axis)) change({ scene, ...reset });
    else change({ scene, ...reset, ...startOf(axes[0]) });
  };
  const scenes = Object.entries(sceneWords).filter(([name]) => name !== 'own' || ownScene !== null);
  return (
    <fieldset class="series">
      <legend>{t('Chart {number}', { number })}</legend>
      {onRemove && (
        <button
          type="button"
          class="quiet remove"
          onClick={onRemove}
          aria-label={t('Remove chart {number}', { number })}
        >
          {t('Remove')}
        </button>
      )}
      <div class="fields">
        <Select
          label={t('Scene')}
          value={series.scene}
          options={scenes.map(([name, { label }]) => [name, name === 'own' ? (ownScene ?? t(label)) : t(label)])}
          onChange={chooseScene}
        />
        <Select
          label={t('What changes')}
          value={series.axis}
          options={words.axes.map((axis) => [axis, t(axisWords[axis].label)])}
          onChange={(axis) => change(startOf(axis as Axis))}
        />
        <p class="hint wide">{t(words.help)}</p>
        {isNamed(series.axis) ? (
          <NamesField
            label={t(axisWords[series.axis].label)}
            words={series.axis === 'kind' ? Object.values(lightKinds) : Object.values(shadings)}
            values={series.values}
            onChange={(values) => change({ values })}
          />
        ) : (
          <ValuesField
            label={valuesLabel(series.axis)}
            values={series.values}
            hint={t(valueHints[series.axis])}
            onChange={(values) => change({ values })}
          />
        )}
        {isPlanes && series.axis !== 'objects' && (
          <NumberField
            label={t('Planes along a side')}
            value={series.n}
            min={1}
            max={100}
            onChange={(n) => change({ n })}
          />
        )}
        {series.axis !== 'lights' && series.scene !== 'own' && (
          <NumberField
            label={t('Lights')}
            value={series.lights === 'objects' ? 100 : series.lights}
            min={0}
            max={20_000}
            isDisabled={series.lights === 'objects'}
            onChange={(lights) => change({ lights })}
          />
        )}
        {series.scene !== 'own' && series.axis !== 'kind' && series.axis !== 'shadows' && (
          <Select
            label={t('Kind of lights')}
            value={series.lightKind ?? 'points'}
            options={lightKindNames.map((name) => [name, t(lightKinds[name].label)])}
            onChange={(name) => change({ lightKind: name as LightKind })}
          />
        )}
        {series.scene !== 'own' && (
          <Select
            label={t('Reach of a light')}
            value={String(series.lightRange ?? '')}
            options={[
              ['', t('The scene’s')],
              ...rangesWith(series.lightRange).map((m) => [String(m), `${m} m`] as const),
            ]}
            onChange={(metres) => change({ lightRange: metres === '' ? null : Number(metres) })}
          />
        )}
        {series.axis !== 'shading' && (
          <Select
            label={t('Shading')}
            value={series.shading ?? 'own'}
            options={shadingNames.map((name) => [name, t(shadings[name].label)])}
            onChange={(name) => change({ shading: name as Shading })}
          />
        )}
        {hintsOf(series).map((hint) => (
          <p key={hint} class="hint wide">
            {hint}
          </p>
        ))}
        {series.axis === 'objects' && (
          <label class="check wide">
            <input
              type="checkbox"
              checked={series.lights === 'objects'}
              onChange={({ currentTarget }) => change({ lights: currentTarget.checked ? 'objects' : 100 })}
            />
            {t('As many lights as planes')}
          </label>
        )}
      </div>
    </fieldset>
  );
}

/** Label of the field of values, with their unit. */
function valuesLabel(axis: Axis): string {
  const unit = t(axisWords[axis].unit);
  return axis === 'pixels' ? t('Values: {unit}, in thousands', { unit }) : t('Values: {unit}', { unit });
}

/** Explanations of the kind of lights and the shading, unless they are the defaults. */
function hintsOf({ axis, lightKind = 'points', shading = 'own' }: SeriesChoice): string[] {
  const kind = axis === 'kind' || lightKind === 'points' ? [] : [t(lightKinds[lightKind].help)];
  return axis === 'shading' || shading === 'own' ? kind : [...kind, t(shadings[shading].help)];
}

/** Ranges of lights offered in the menu (m), including the chosen range. */
function rangesWith(chosen: number | null | undefined): number[] {
  return [...new Set([0.5, 1, 2, 4, 8, ...(chosen == null ? [] : [chosen])])].sort((a, b) => a - b);
}

/** An axis with its default values. */
function startOf(axis: Axis): Pick<SeriesChoice, 'axis' | 'values' | 'lights' | 'lightKind'> {
  const values: Record<Axis, number[]> = {
    lights: [10, 100, 1000],
    objects: [1, 25, 100, 400],
    pixels: [230, 922, 2074],
    overdraw: [1, 2, 4, 8],
    shadows: [0, 1, 4, 16],
    kind: ['points', 'field'].map((name) => lightKindNames.indexOf(name as LightKind)),
    shading: ['flat', 'gouraud', 'phong'].map((name) => shadingNames.indexOf(name as Shading)),
  };
  const reset = axis === 'shadows' ? { lightKind: undefined } : {};
  return { ...reset, axis, values: values[axis], lights: axis === 'lights' ? 0 : axis === 'shadows' ? 64 : 100 };
}
