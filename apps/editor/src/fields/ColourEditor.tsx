import { Popover } from '@base-ui/react/popover';
import type { ColourField } from '@farol/engine/fields';
import { type ReactNode, useRef } from 'react';
import { HexColorPicker } from 'react-colorful';
import { joinColour, splitColour } from '../ui/colour';
import { NumberInput } from '../ui/NumberInput';
import { TextInput } from '../ui/TextInput';
import type { FieldEditorProps } from './FieldEditorProps';

/** A linear colour, shown as sRGB and a factor of intensity where it is brighter than a screen. */
export function ColourEditor(props: FieldEditorProps<ColourField>): ReactNode {
  const { value, mixed, label, description, disabled, onPreview, onCommit, onDiscard } = props;
  const { hex, intensity } = splitColour(value ?? [0, 0, 0]);
  /** The intensity while the picker is dragged: it must not follow the rounding of the screen's colour. */
  const held = useRef<number | null>(null);

  const pick = (next: string): void => {
    held.current ??= intensity;
    const colour = joinColour(next, held.current);
    if (colour && next !== hex) onPreview(colour);
  };
  const commit = (): void => {
    held.current = null;
    onCommit();
  };

  return (
    <Popover.Root onOpenChange={(open) => !open && commit()}>
      <Popover.Trigger className="colour" aria-label={label} aria-description={description} disabled={disabled}>
        <span className={mixed ? 'swatch mixed' : 'swatch'} style={mixed ? undefined : { background: hex }} />
        <span className="colour-text">
          {mixed ? '—' : hex}
          {intensity > 1 && <span className="dim"> × {Number(intensity.toFixed(2))}</span>}
        </span>
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Positioner className="positioner" sideOffset={4} align="end">
          <Popover.Popup className="popup colour-popup" aria-label={label}>
            <div onPointerUp={commit} onKeyUp={commit}>
              <HexColorPicker color={hex} onChange={pick} />
            </div>
            <div className="colour-fields">
              <TextInput
                value={hex}
                label={`${label} as sRGB`}
                onCommit={(text) => {
                  const colour = joinColour(text, intensity);
                  if (colour) onCommit(colour);
                }}
              />
              <NumberInput
                value={intensity}
                min={1}
                step={0.1}
                unit="×"
                label={`${label} intensity`}
                description="Factor above what a screen can show"
                handle={<span className="grip" />}
                onPreview={(next) => {
                  const colour = joinColour(hex, next);
                  if (colour) onPreview(colour);
                }}
                onCommit={() => onCommit()}
                onDiscard={onDiscard}
              />
            </div>
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
