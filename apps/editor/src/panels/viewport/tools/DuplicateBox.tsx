import { t, tCount, toDegrees, toRadians } from '@farol/editing';
import { type ReactNode, useEffect, useRef } from 'react';
import {
  type Arrangement,
  type ArrangementKind,
  type LightColours,
  MOST_COPIES,
} from '../../../model/arrange/Arrangement';
import { useEditor, useSignal } from '../../../ui/EditorContext';
import { Icon } from '../../../ui/Icon';
import type { DuplicateTool } from '../../../viewport/placing/DuplicateTool';
import { ChoiceRow, SwitchRow } from '../../../ui/SettingRow';
import { NumberRow, TripleRow } from './ToolField';
import { Button } from '../../../ui/Button';

interface PartProps {
  readonly tool: DuplicateTool;
  readonly value: Arrangement;
}

/** Properties of a row: value of a setting of the tool, and its setter. */
const bind = <K extends keyof Arrangement>(
  tool: DuplicateTool,
  name: K,
): { value: Arrangement[K]; onChange(value: Arrangement[K]): void } => ({
  value: tool.arrangement[name],
  onChange: (value) => tool.set({ [name]: value }),
});

const kinds = (): { value: ArrangementKind; label: string; help: string }[] => [
  { value: 'line', label: t('Along a line'), help: t('One after another, equally far apart') },
  { value: 'ring', label: t('On a ring'), help: t('Round where the original is') },
  { value: 'grid', label: t('On a grid'), help: t('In rows, and in layers if wanted') },
  { value: 'scatter', label: t('Over a surface'), help: t('At random, evenly over a surface') },
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
      <TripleRow label={t('Distance')} step={0.1} {...bind(tool, 'offset')} />
    </>
  );
}

function RingPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <Count tool={tool} value={value} />
      <NumberRow label={t('Radius')} unit="m" min={0} step={0.1} {...bind(tool, 'radius')} />
      <NumberRow
        label={t('Arc')}
        unit="°"
        value={toDegrees(value.arc)}
        min={-360}
        max={360}
        step={5}
        onChange={(arc) => tool.set({ arc: toRadians(arc) })}
      />
      <SwitchRow label={t('Turn with the ring')} {...bind(tool, 'turns')} />
    </>
  );
}

function GridPart({ tool }: PartProps): ReactNode {
  return (
    <>
      <TripleRow label={t('Count')} min={1} max={1000} step={1} {...bind(tool, 'counts')} />
      <TripleRow label={t('Distance')} step={0.1} {...bind(tool, 'spacing')} />
    </>
  );
}

function ScatterPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <div className="setting-row">
        <span>{t('Surface')}</span>
        <strong className="tool-value one-line">{tool.target?.name ?? t('None')}</strong>
      </div>
      <p className="tool-note">{t('Click another object, in the picture or the tree, to take its surface.')}</p>
      <Count tool={tool} value={value} />
      <NumberRow label={t('At least apart')} unit="m" min={0} step={0.1} {...bind(tool, 'minimumDistance')} />
      <NumberRow label={t('Above the surface')} unit="m" step={0.1} {...bind(tool, 'height')} />
      <SwitchRow label={t('Only where it faces up')} {...bind(tool, 'upwards')} />
      <SwitchRow label={t('Align to the surface')} {...bind(tool, 'aligns')} />
      <SwitchRow label={t('Turn at random')} {...bind(tool, 'randomTurn')} />
      <PartRow label={t('Sizes differ by')} {...bind(tool, 'sizeVariation')} />
    </>
  );
}

function FollowPart({ tool, value }: PartProps): ReactNode {
  return (
    <>
      <SwitchRow label={t('On the surface below')} {...bind(tool, 'follows')} />
      {value.follows && <NumberRow label={t('Above the surface')} unit="m" step={0.1} {...bind(tool, 'height')} />}
    </>
  );
}

interface PartRowProps {
  readonly label: string;
  /** Value of the row, a share from 0 to 1. */
  readonly value: number;
  onChange(value: number): void;
}

/** Row for a share, shown as a percentage. */
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
      <ChoiceRow label={t('Colours')} options={colours()} {...bind(tool, 'colours')} />
      <SwitchRow label={t('Share the brightness of one light')} {...bind(tool, 'sharesLight')} />
      {!value.sharesLight && tool.total >= MANY_LIGHTS && (
        <p className="tool-note">
          {t('{count} lights of full brightness: share that of one if the picture gets too bright.', {
            count: String(tool.total),
          })}
        </p>
      )}
      <PartRow label={t('Intensities differ by')} {...bind(tool, 'intensityVariation')} />
      <PartRow label={t('Ranges differ by')} {...bind(tool, 'rangeVariation')} />
    </div>
  );
}

/** Number of lights from which the box warns that together they may be too bright. */
const MANY_LIGHTS = 20;

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
        <ChoiceRow label={t('Where')} options={kinds()} {...bind(tool, 'kind')} />
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
        <SwitchRow label={t('In a group')} {...bind(tool, 'grouped')} />
      </div>
      <p className="tool-note" role="status">
        {value.kind === 'scatter' && !tool.target
          ? t('Click the object to scatter the copies over.')
          : tool.total < requestedCount
            ? t('{count} of {wanted} fit: more would be too close together.', {
                count: tool.total,
                wanted: requestedCount,
              })
            : tCount(tool.total, '{count} in all', '{count} in all')}
      </p>
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={() => tools.end(tool)} />
        <Button type="submit" look="primary" label={t('Duplicate')} disabled={tool.total <= tool.sources.length} />
      </div>
    </form>
  );
}
