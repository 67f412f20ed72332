import { formatNumber, splitColour, t } from '@farol/editing';
import {
  type ColourKey,
  colourKeys,
  curveAt,
  type CurveKey,
  gradientAt,
  type GradientField,
  joinKeys,
  opacityKeys,
  type Vector3Tuple,
} from '@farol/engine/fields';
import { type ReactNode, useState } from 'react';
import type { FieldEditorProps } from '../../api/FieldEditorProps';
import { NumberInput } from '../../ui/NumberInput';
import { ColourPicker } from '../ColourPicker';
import { gradientCss } from './gradientCss';
import { gradientPresets } from './gradientPresets';
import { KeyArea } from './KeyArea';
import { roundTime } from './keyList';
import { KeyPresets } from './KeyPresets';
import { KeyTime } from './KeyTime';
import { type KeyEdit, useKeyEdit } from './useKeyEdit';

type ColourUpdate = Vector3Tuple | ((before: Vector3Tuple) => Vector3Tuple);

/** Bar with colour stops above and opacity stops below, fields of the selected stop, and presets. */
export function GradientPopup(props: FieldEditorProps<GradientField>): ReactNode {
  const { field, label, onPreview, onCommit, onAmend, onDiscard } = props;
  const gradient = props.value ?? field.default;
  const [side, setSide] = useState<'colour' | 'opacity'>('colour');
  const colourList = colourKeys(gradient);
  const opacityList = opacityKeys(gradient);
  const colours = useKeyEdit<ColourKey>({
    keys: colourList,
    onPreview: (keys) => onPreview(joinKeys(keys, opacityList)),
    onCommit: (keys) => onCommit(keys && joinKeys(keys, opacityList)),
    onAmend: (keys) => onAmend(joinKeys(keys, opacityList)),
    onDiscard,
  });
  const opacities = useKeyEdit<CurveKey>({
    keys: opacityList,
    onPreview: (keys) => onPreview(joinKeys(colourList, keys)),
    onCommit: (keys) => onCommit(keys && joinKeys(colourList, keys)),
    onAmend: (keys) => onAmend(joinKeys(colourList, keys)),
    onDiscard,
  });
  const [, opacity] = opacityList[opacities.selected];
  const timeLabels = { label: t('Time of the stop'), removeLabel: t('Remove the stop') };
  const help = t('A click adds a stop, a drag moves it, a double click or Delete removes it.');

  return (
    <div className="gradient-popup">
      <KeyArea
        className="gradient-stops above"
        label={t('Stops of colour of {label}', { label })}
        description={help}
        keys={colourList.map(([x, colour], i) => ({
          x,
          label: t('Colour {number} of {count}', { number: i + 1, count: colourList.length }),
          valueText: t('{colour} at {time}', { colour: splitColour(colour).hex, time: x }),
          style: { ['--stop' as string]: splitColour(colour).hex },
        }))}
        selected={side === 'colour' ? colours.selected : -1}
        onSelect={(index) => {
          setSide('colour');
          colours.select(index);
        }}
        onAdd={(x) => {
          setSide('colour');
          colours.add([roundTime(x), gradientAt(gradient, roundTime(x)).colour]);
        }}
        onDrag={(x) => colours.change(([, colour]) => [roundTime(x), colour])}
        onEnd={colours.end}
        onNudge={(right) => colours.nudge(([time, colour]) => [roundTime(time + right * 0.01), colour])}
        onRemove={colours.remove}
      />
      <div className="gradient-bar checkered">
        <span style={{ background: gradientCss(gradient) }} />
      </div>
      <KeyArea
        className="gradient-stops below"
        label={t('Stops of opacity of {label}', { label })}
        description={help}
        keys={opacityList.map(([x, value], i) => ({
          x,
          label: t('Opacity {number} of {count}', { number: i + 1, count: opacityList.length }),
          valueText: t('{opacity} at {time}', { opacity: formatNumber(value, 'short'), time: x }),
          style: {
            ['--stop' as string]: `rgb(${Math.round(value * 255)} ${Math.round(value * 255)} ${Math.round(value * 255)})`,
          },
        }))}
        selected={side === 'opacity' ? opacities.selected : -1}
        onSelect={(index) => {
          setSide('opacity');
          opacities.select(index);
        }}
        onAdd={(x) => {
          setSide('opacity');
          opacities.add([roundTime(x), Number(curveAt(opacityList, roundTime(x)).toFixed(3))]);
        }}
        onDrag={(x) => opacities.change(([, value]) => [roundTime(x), value])}
        onEnd={opacities.end}
        onNudge={(right, up) =>
          opacities.nudge(([time, value]) => [roundTime(time + right * 0.01), roundTime(value + up * 0.01)])
        }
        onRemove={opacities.remove}
      />
      {side === 'colour' ? (
        <>
          <KeyTime edit={colours} {...timeLabels} />
          <StopColour edit={colours} />
        </>
      ) : (
        <>
          <KeyTime edit={opacities} {...timeLabels} />
          <div className="key-fields">
            <span className="key-field-name" aria-hidden="true">
              {t('Opacity')}
            </span>
            <NumberInput
              value={opacity}
              min={0}
              max={1}
              step={0.01}
              slider
              digits="short"
              label={t('Opacity of the stop')}
              handle={<span className="grip" />}
              onPreview={(next) => opacities.change(([time]) => [time, next])}
              onCommit={() => opacities.end(true)}
              onDiscard={() => opacities.end(false)}
            />
          </div>
        </>
      )}
      <KeyPresets
        presets={gradientPresets().map(({ id, label: name, gradient: preset }) => ({
          ...{ id, label: name },
          picture: (
            <span className="gradient-picture checkered">
              <span style={{ background: gradientCss(preset) }} />
            </span>
          ),
          choose: () => onCommit(preset),
        }))}
      />
    </div>
  );
}

function StopColour({ edit }: { edit: KeyEdit<ColourKey> }): ReactNode {
  const update =
    (next: ColourUpdate) =>
    ([time, before]: ColourKey): ColourKey => [time, typeof next === 'function' ? next(before) : next];
  return (
    <ColourPicker
      key={edit.selected}
      value={edit.keys[edit.selected][1]}
      mixed={false}
      label={t('Colour of the stop')}
      onPreview={(next) => edit.change(update(next))}
      onCommit={(next) => {
        if (next !== undefined) edit.change(update(next));
        edit.end(true);
      }}
      onAmend={(next) => edit.amend(update(next))}
      onDiscard={() => edit.end(false)}
    />
  );
}
