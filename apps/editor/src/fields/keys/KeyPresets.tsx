import { t } from '@farol/editing';
import type { ReactNode } from 'react';

interface KeyPresetsProps<P> {
  readonly presets: readonly P[];
  readonly picture: (preset: P) => ReactNode;
  readonly onChoose: (preset: P) => void;
}

/** Curves or gradients to begin from, as pictures. */
export function KeyPresets<P extends { readonly id: string; readonly label: string }>(
  props: KeyPresetsProps<P>,
): ReactNode {
  return (
    <div className="key-presets" role="group" aria-label={t('Presets')}>
      {props.presets.map((preset) => (
        <button
          key={preset.id}
          type="button"
          className="key-preset"
          aria-label={preset.label}
          title={preset.label}
          onClick={() => props.onChoose(preset)}
        >
          {props.picture(preset)}
        </button>
      ))}
    </div>
  );
}
