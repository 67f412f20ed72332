import { t, tCount, toDegrees, toRadians } from '@farol/editing';
import { type ReactNode, useEffect, useRef } from 'react';
import {
  type Arrangement,
  type ArrangementKind,
  type LightColours,
  MOST_COPIES,
  sharesLight,
} from '../../../model/arrange/Arrangement';
import { useEditor, useSignal } from '../../../ui/EditorContext';
import { Icon } from '../../../ui/Icon';
import type { DuplicateTool } from '../../../viewport/placing/DuplicateTool';
import { ChoiceRow, NumberRow, SwitchRow, TripleRow } from './ToolField';

interface PartProps {
  readonly tool: DuplicateTool;
  readonly value: Arrangement;
}

const kinds = (): { value: ArrangementKind; label: string; help: string }[] => [
  { value: 'line', label: t('Along a line'), help: t('One after another, equally far apart') },
  { value: 'ring', label: t('On a ring'), help: t('Round where the original is') },
  { value: 'grid', label: t('On a grid'), help: t('In rows, one above another if wanted') },
  { value: 'scatter', label: t('Over a surface'), help: t('At random, evenly over what is drawn') },
];

const colours = (): { value: LightColours; label: string }[] => [
  { value: 'same', label: t('As the original') },
  { value: 'random', label: t('Any hue') },
  { value: 'rainbow', label: t('All hues in turn') },
];

function Count({ tool, value }: PartProps): ReactNode {
  return (
    <NumberRow
      label={t('Count')}
      value={value.count}
      min={1}
      max={MOST_COPIES}
      step={1}
      onChange={(count) => tool.set({ count: Math.round(count) })}
    />
  );
}

function LinePart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <Count tool={tool} value={value} />
      <TripleRow label={t('Distance')} value={value.offset} step={0.1} onChange={(offset) => tool.set({ offset })} />
    </>
  );
}

function RingPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <Count tool={tool} value={value} />
      <NumberRow
        label={t('Radius')}
        unit="m"
        value={value.radius}
        min={0}
        step={0.1}
        onChange={(radius) => tool.set({ radius })}
      />
      <NumberRow
        label={t('Arc')}
        unit="°"
        value={toDegrees(value.arc)}
        min={-360}
        max={360}
        step={5}
        onChange={(arc) => tool.set({ arc: toRadians(arc) })}
      />
      <SwitchRow label={t('Turn with the ring')} value={value.turns} onChange={(turns) => tool.set({ turns })} />
    </>
  );
}

function GridPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <TripleRow
        label={t('Count')}
        value={value.counts}
        min={1}
        max={1000}
        step={1}
        onChange={(counts) => tool.set({ counts })}
      />
      <TripleRow label={t('Distance')} value={value.spacing} step={0.1} onChange={(spacing) => tool.set({ spacing })} />
    </>
  );
}

function ScatterPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <div className="tool-row">
        <span>{t('Surface')}</span>
        <strong className="tool-value">{tool.target?.name ?? t('None')}</strong>
      </div>
      <p className="tool-note">{t('Click another object, in the picture or the tree, to take its surface.')}</p>
      <Count tool={tool} value={value} />
      <NumberRow
        label={t('At least apart')}
        unit="m"
        value={value.minimumDistance}
        min={0}
        step={0.1}
        onChange={(minimumDistance) => tool.set({ minimumDistance })}
      />
      <NumberRow
        label={t('Above the surface')}
        unit="m"
        value={value.height}
        step={0.1}
        onChange={(height) => tool.set({ height })}
      />
      <SwitchRow
        label={t('Only where it faces up')}
        value={value.upwards}
        onChange={(upwards) => tool.set({ upwards })}
      />
      <SwitchRow label={t('Align to the surface')} value={value.aligns} onChange={(aligns) => tool.set({ aligns })} />
      <SwitchRow
        label={t('Turn at random')}
        value={value.randomTurn}
        onChange={(randomTurn) => tool.set({ randomTurn })}
      />
      <PartRow
        label={t('Sizes differ by')}
        value={value.sizeVariation}
        onChange={(sizeVariation) => tool.set({ sizeVariation })}
      />
    </>
  );
}

function FollowPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <SwitchRow
        label={t('On the surface below')}
        value={value.follows}
        onChange={(follows) => tool.set({ follows })}
      />
      {value.follows && (
        <NumberRow
          label={t('Above the surface')}
          unit="m"
          value={value.height}
          step={0.1}
          onChange={(height) => tool.set({ height })}
        />
      )}
    </>
  );
}

interface PartRowProps {
  readonly label: string;
  /** Share, 0 to 1. */
  readonly value: number;
  onChange(value: number): void;
}

/** A share, shown as a percentage. */
function PartRow({ label, value, onChange }: PartRowProps): ReactNode {
  return (
    <NumberRow
      label={label}
      unit="%"
      value={Math.round(value * 1000) / 10}
      min={0}
      max={100}
      step={5}
      onChange={(percent) => onChange(percent / 100)}
    />
  );
}

function LightPart({ tool, value }: PartProps): ReactNode {
  return (
    <div role="group" aria-label={t('Lights')} className="tool-part">
      <ChoiceRow
        label={t('Colours')}
        value={value.colours}
        options={colours()}
        onChange={(chosen) => tool.set({ colours: chosen })}
      />
      <SwitchRow
        label={t('As bright as one in all')}
        value={sharesLight(value, tool.total)}
        onChange={(shares) => tool.set({ sharesLight: shares })}
      />
      <PartRow
        label={t('Intensities differ by')}
        value={value.intensityVariation}
        onChange={(intensityVariation) => tool.set({ intensityVariation })}
      />
      <PartRow
        label={t('Ranges differ by')}
        value={value.rangeVariation}
        onChange={(rangeVariation) => tool.set({ rangeVariation })}
      />
    </div>
  );
}

const parts = { line: LinePart, ring: RingPart, grid: GridPart, scatter: ScatterPart };

/** Settings of the tool "Duplicate along…", updating its preview. */
export function DuplicateBox({ tool }: { readonly tool: DuplicateTool }): ReactNode {
  const { tools } = useEditor();
  useSignal(tool.changed);
  const value = tool.arrangement;
  const Part = parts[value.kind];
  const form = useRef<HTMLFormElement>(null);
  useEffect(() => form.current?.querySelector<HTMLElement>('button')?.focus(), []);
  const name =
    tool.sources.length === 1 ? tool.sources[0].name : tCount(tool.sources.length, '{count} object', '{count} objects');
  const requestedCount = value.kind === 'grid' ? tool.total : value.count;
  const isRandom =
    value.kind === 'scatter' || value.colours === 'random' || value.intensityVariation + value.rangeVariation > 0;
  return (
    <form
      ref={form}
      className="tool-box"
      aria-label={t('Duplicate {name}', { name })}
      onSubmit={(event) => {
        event.preventDefault();
        tool.apply();
      }}
    >
      <header className="tool-head">
        <Icon name="duplicate" />
        <strong>{t('Duplicate {name}', { name })}</strong>
      </header>
      <div className="tool-fields">
        <ChoiceRow label={t('Where')} value={value.kind} options={kinds()} onChange={(kind) => tool.set({ kind })} />
        <Part tool={tool} value={value} />
        {value.kind !== 'scatter' && <FollowPart tool={tool} value={value} />}
        {tool.hasLights && <LightPart tool={tool} value={value} />}
        {isRandom && (
          <NumberRow
            label={t('Seed')}
            value={value.seed}
            min={0}
            max={999_999}
            step={1}
            onChange={(seed) => tool.set({ seed: Math.round(seed) })}
          />
        )}
        <SwitchRow label={t('In a group')} value={value.grouped} onChange={(grouped) => tool.set({ grouped })} />
      </div>
      <p className="tool-note" role="status">
        {value.kind === 'scatter' && !tool.target
          ? t('Click what they shall be scattered over.')
          : tool.total < requestedCount
            ? t('{count} of {wanted} fit: the others would be closer.', { count: tool.total, wanted: requestedCount })
            : tCount(tool.total, '{count} in all', '{count} in all')}
      </p>
      <div className="dialog-buttons">
        <button type="button" className="button framed" onClick={() => tools.end(tool)}>
          {t('Cancel')}
        </button>
        <button type="submit" className="button primary" disabled={tool.total <= tool.sources.length}>
          {t('Duplicate')}
        </button>
      </div>
    </form>
  );
}
