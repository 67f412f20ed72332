import { Popover } from '@base-ui/react/popover';
import { splitColour } from '@farol/editing';
import type { ColourField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { ColourPicker } from './ColourPicker';

/** A linear colour, edited as sRGB with an intensity factor for colours brighter than the screen. */
export function ColourEditor(props: FieldEditorProps<ColourField>): ReactNode {
  const { value, mixed, label, description, disabled } = props;
  const { hex, intensity } = splitColour(value ?? [0, 0, 0]);
  return (
    <Popover.Root>
      <Popover.Trigger className="colour" aria-label={label} aria-description={description} disabled={disabled}>
        <span className={mixed ? 'swatch mixed' : 'swatch'} style={mixed ? undefined : { background: hex }} />
        <span className="colour-text">
          {mixed ? '—' : hex}
          {!mixed && intensity > 1 && <span className="dim"> × {Number(intensity.toFixed(2))}</span>}
        </span>
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Positioner className="positioner" sideOffset={4} align="end">
          <Popover.Popup className="popup colour-popup" aria-label={label}>
            <ColourPicker {...props} />
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
