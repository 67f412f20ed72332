import { splitColour, t, withIntensity, withScreenColour } from '@farol/editing';
import type { ColourField } from '@farol/engine/fields';
import { type ReactNode, useEffect, useRef } from 'react';
import { HexColorPicker } from 'react-colorful';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { NumberInput } from '../ui/NumberInput';
import { TextInput } from '../ui/TextInput';

type ColourPickerProps = Pick<
  FieldEditorProps<ColourField>,
  'value' | 'mixed' | 'label' | 'onPreview' | 'onCommit' | 'onAmend' | 'onDiscard'
>;

/** A linear colour to be picked or typed: as sRGB, and a factor where it is brighter than a screen. */
export function ColourPicker(props: ColourPickerProps): ReactNode {
  const { value, mixed, label, onPreview, onCommit, onAmend, onDiscard } = props;
  const { hex, intensity } = splitColour(value ?? [0, 0, 0]);
  /** Whether the button, the finger or a key is down that changes the picker. */
  const pressed = useRef(false);

  const pick = (next: string): void => {
    const update = withScreenColour(next);
    if (!update || next === hex) return;
    // the picker tells of its last change after the next frame, on a busy page long after the button is up
    if (pressed.current) onPreview(update);
    else onAmend(update);
  };
  const press = (): void => {
    pressed.current = true;
  };
  const release = (): void => {
    if (!pressed.current) return;
    pressed.current = false;
    onCommit();
  };
  const pressPointer = (): void => {
    press();
    // the pointer may go up outside of the picker
    const end = new AbortController();
    const lift = (): void => {
      end.abort();
      release();
    };
    for (const name of ['pointerup', 'pointercancel']) addEventListener(name, lift, { signal: end.signal });
  };
  const last = useRef(release);
  useEffect(() => {
    last.current = release;
  });
  // what was picked when the picker went counts
  useEffect(() => () => last.current(), []);

  return (
    <>
      <div onPointerDown={pressPointer} onKeyDown={press} onKeyUp={release}>
        <HexColorPicker color={hex} onChange={pick} />
      </div>
      <div className="colour-fields">
        <TextInput
          value={mixed ? null : hex}
          label={t('{label} as sRGB', { label })}
          onCommit={(text) => {
            const update = withScreenColour(text);
            if (update) onCommit(update);
          }}
        />
        <NumberInput
          value={mixed ? null : intensity}
          min={1}
          step={0.1}
          unit="×"
          label={t('{label} intensity', { label })}
          description={t('Factor above what a screen can show')}
          handle={<span className="grip" />}
          onPreview={(next) => onPreview(withIntensity(next))}
          onPreviewEach={(update) =>
            onPreview((before) => withIntensity(update(splitColour(before).intensity))(before))
          }
          onCommit={() => onCommit()}
          onDiscard={onDiscard}
        />
      </div>
    </>
  );
}
