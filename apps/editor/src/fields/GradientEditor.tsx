import type { GradientField } from '@farol/engine/fields';
import { lazy, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { gradientCss } from './keys/gradientCss';
import { KeysPopover } from './keys/KeysPopover';

const GradientPopup = lazy(async () => ({ default: (await import('./keys/GradientPopup')).GradientPopup }));

/** A bar with a gradient, which opens its stops. */
export function GradientEditor(props: FieldEditorProps<GradientField>): ReactNode {
  const { value, mixed, label, description, disabled } = props;
  const picture =
    mixed || value === null ? (
      <span className="keys-mixed">—</span>
    ) : (
      <span className="gradient-picture checkered">
        <span style={{ background: gradientCss(value) }} />
      </span>
    );
  return (
    <KeysPopover {...{ label, description, disabled, picture }}>
      <GradientPopup {...props} />
    </KeysPopover>
  );
}
