import { formatNumber, t } from '@farol/editing';
import type { Curve, CurveField, CurveKey } from '@farol/engine/fields';
import { type ReactNode, useState } from 'react';
import type { FieldEditorProps } from '../../api/FieldEditorProps';
import { NumberInput } from '../../ui/NumberInput';
import { CurvePicture } from './CurvePicture';
import { curvePresets } from './curvePresets';
import { KeyArea } from './KeyArea';
import { roundTime } from './keyList';
import { KeyPresets } from './KeyPresets';
import { KeyTime } from './KeyTime';
import { useKeyEdit } from './useKeyEdit';
import { shareOf, valueAtShare, type ValueRange, valueRange } from './valueRange';

/** Graph of a curve with its keys, numbers of the selected key, and presets. */
export function CurvePopup(props: FieldEditorProps<CurveField>): ReactNode {
  const { field, label, onPreview, onCommit, onAmend, onDiscard } = props;
  const curve = props.value ?? field.default;
  const edit = useKeyEdit<CurveKey>({ keys: curve, onPreview, onCommit, onAmend, onDiscard });
  /** Range of the graph, fixed during a drag; null otherwise. */
  const [held, hold] = useState<ValueRange | null>(null);
  const range = held ?? valueRange(field, curve);
  const { low, high } = range;
  const unit = (high - low) / 100;

  const keyAt = (x: number, y: number): CurveKey => [roundTime(x), valueAtShare(range, y)];
  const drag = (begin: () => void): void => {
    hold(range);
    begin();
  };
  const limited = (value: number): number =>
    Number(Math.min(Math.max(value, field.min ?? -Infinity), field.max ?? Infinity).toPrecision(9));
  const gridLines = [0.25, 0.5, 0.75];

  return (
    <div className="curve-popup">
      <div className="curve-scale" aria-hidden="true">
        <span>{formatNumber(high, 'short')}</span>
        <span>{formatNumber(low, 'short')}</span>
      </div>
      <KeyArea
        className="curve-graph"
        label={t('Graph of {label}', { label })}
        description={t('A click adds a key, a drag moves it, a double click or Delete removes it.')}
        keys={curve.map(([keyTime, keyValue], i) => ({
          x: keyTime,
          y: shareOf(range, keyValue),
          label: t('Key {number} of {count}', { number: i + 1, count: curve.length }),
          valueText: t('Time {time}, value {value}', { time: keyTime, value: formatNumber(keyValue, 'long') }),
        }))}
        selected={edit.selected}
        onSelect={edit.select}
        onAdd={(x, y) => drag(() => edit.add(keyAt(x, y)))}
        onDrag={(x, y) => drag(() => edit.change(() => keyAt(x, y)))}
        onEnd={(keeps) => {
          hold(null);
          edit.end(keeps);
        }}
        onNudge={(right, up) =>
          drag(() => edit.nudge(([at, of]) => [roundTime(at + right * 0.01), limited(of + up * unit)]))
        }
        onRemove={edit.remove}
      >
        <svg className="curve-grid" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
          {gridLines.map((at) => (
            <path key={at} d={`M${at} 0V1M0 ${at}H1`} />
          ))}
          {low < 0 && high > 0 && <path className="curve-zero" d={`M0 ${1 - shareOf(range, 0)}H1`} />}
        </svg>
        <CurvePicture curve={curve} range={range} />
      </KeyArea>
      <div className="curve-times" aria-hidden="true">
        <span>0</span>
        <span>{t('time')}</span>
        <span>1</span>
      </div>
      <KeyTime edit={edit} label={t('Time of the key')} removeLabel={t('Remove the key')}>
        <span className="key-field-name" aria-hidden="true">
          {t('Value')}
        </span>
        <NumberInput
          value={curve[edit.selected][1]}
          min={field.min}
          max={field.max}
          step={field.step ?? 0.01}
          unit={field.unit}
          digits="short"
          label={t('Value of the key')}
          handle={<span className="grip" />}
          onPreview={(next) => edit.change(([at]) => [at, next])}
          onCommit={() => edit.end(true)}
          onDiscard={() => edit.end(false)}
        />
      </KeyTime>
      <Presets curve={curve} field={field} onChoose={(preset) => onCommit(preset)} />
    </div>
  );
}

interface PresetsProps {
  readonly curve: Curve;
  readonly field: CurveField;
  onChoose(curve: Curve): void;
}

/** Presets of curves, scaled to the present curve's height. */
function Presets({ curve, field, onChoose }: PresetsProps): ReactNode {
  const { min = -Infinity, max = Infinity } = field;
  const largest = Math.max(...curve.map(([, value]) => value));
  const high = Math.min(largest > 0 ? largest : 1, max);
  const low = Math.min(Math.max(0, min), high);
  const range = { low, high: low < high ? high : low + 1 };
  return (
    <KeyPresets
      presets={curvePresets(low, high).map(({ id, label, curve: preset }) => ({
        ...{ id, label },
        picture: <CurvePicture curve={preset} range={range} />,
        choose: () => onChoose(preset),
      }))}
    />
  );
}
