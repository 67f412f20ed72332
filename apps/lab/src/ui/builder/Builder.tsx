import { t } from '@farol/editing';
import type { Configuration, SeriesChoice } from '../../plan/Configuration';
import { CompetitorBoxes } from './CompetitorBoxes';
import { EffortFields } from './EffortFields';
import { SeriesFields } from './SeriesFields';
import { SizeFields } from './SizeFields';

/** Maximum number of charts of a run. */
const MOST_SERIES = 8;

interface BuilderProps {
  configuration: Configuration;
  unavailable: Readonly<Record<string, string | null>>;
  ownScene: string | null;
  onChange(configuration: Configuration): void;
}

/** All settings of a run. A changed size or choice of competitors keeps the preset; changed series make it `custom`. */
export function Builder({ configuration, unavailable, ownScene, onChange }: BuilderProps) {
  const { series, width, height, competitors, effort } = configuration;
  const change = (changes: Partial<Configuration>): void => onChange({ ...configuration, ...changes });
  const changeSeries = (next: readonly SeriesChoice[]): void => change({ series: next, preset: 'custom' });
  return (
    <fieldset class="builder">
      <legend class="visually-hidden">{t('Choices')}</legend>
      {series.map((each, index) => (
        <SeriesFields
          // oxlint-disable-next-line react/no-array-index-key -- series have no other key
          key={index}
          series={each}
          number={index + 1}
          ownScene={ownScene}
          onChange={(changed) => changeSeries(series.with(index, changed))}
          onRemove={series.length > 1 ? () => changeSeries(series.toSpliced(index, 1)) : undefined}
        />
      ))}
      {series.length < MOST_SERIES && (
        <button type="button" onClick={() => changeSeries([...series, series[series.length - 1]])}>
          {t('Add a chart')}
        </button>
      )}
      <SizeFields width={width} height={height} onChange={change} />
      <CompetitorBoxes
        chosen={competitors}
        unavailable={unavailable}
        onChange={(chosen) => change({ competitors: chosen })}
      />
      <EffortFields effort={effort} onChange={(next) => change({ effort: next, preset: 'custom' })} />
    </fieldset>
  );
}
