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

/** Labels the sliders of react-colorful in the user's language; the library names them in English. */
function nameSliders(picker: HTMLElement | null): void {
  const names = [t('Saturation and brightness'), t('Hue')];
  picker?.querySelectorAll('[role=slider]').forEach((slider, i) => slider.setAttribute('aria-label', names[i]));
}

/** Picks or types a linear colour, as sRGB with an intensity factor for colours brighter than the screen. */
export function ColourPicker(props: ColourPickerProps): ReactNode {
  const { value, mixed, label, onPreview, onCommit, onAmend, onDiscard } = props;
  const { hex, intensity } = splitColour(value ?? [0, 0, 0]);
  /** Whether a button, finger or key that changes the picker is down. */
  const pressed = useRef(false);

  const pick = (next: string): void => {
    const update = withScreenColour(next);
    if (!update || next === hex) return;
    // the picker reports its last change a frame late, which may be after the button was released
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
    // the pointer may be released outside of the picker
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
  // commits a pending change when the picker is closed
  useEffect(() => () => last.current(), []);

  return (
    <>
      <div ref={nameSliders} onPointerDown={pressPointer} onKeyDown={press} onKeyUp={release}>
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
