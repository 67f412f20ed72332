import type { Configuration, SeriesChoice } from '../../plan/Configuration';
import { CompetitorBoxes } from './CompetitorBoxes';
import { EffortFields } from './EffortFields';
import { SeriesFields } from './SeriesFields';
import { SizeFields } from './SizeFields';

/** Most charts that a run may have. */
const MOST_SERIES = 8;

interface BuilderProps {
  configuration: Configuration;
  unavailable: Readonly<Record<string, string | null>>;
  ownScene: string | null;
  onChange(configuration: Configuration): void;
}

/** Every choice of a run. What a preset measures stays that preset with another size or other competitors. */
export function Builder({ configuration, unavailable, ownScene, onChange }: BuilderProps) {
  const { series, width, height, competitors, effort } = configuration;
  const change = (changes: Partial<Configuration>): void => onChange({ ...configuration, ...changes });
  const changeSeries = (next: readonly SeriesChoice[]): void => change({ series: next, preset: 'custom' });
  return (
    <fieldset class="builder">
      <legend class="visually-hidden">Choices</legend>
      {series.map((each, index) => (
        <SeriesFields
          // oxlint-disable-next-line react/no-array-index-key -- a series has no name but its place
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
          Add a chart
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
