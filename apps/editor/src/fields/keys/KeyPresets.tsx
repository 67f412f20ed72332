import { t } from '@farol/editing';
import type { ReactNode } from 'react';

/** Something to begin from. */
export interface KeyPreset {
  readonly id: string;
  readonly label: string;
  readonly picture: ReactNode;
  choose(): void;
}

/** Curves or gradients to begin from, as pictures. */
export function KeyPresets({ presets }: { presets: readonly KeyPreset[] }): ReactNode {
  return (
    <div className="key-presets" role="group" aria-label={t('Presets')}>
      {presets.map(({ id, label, picture, choose }) => (
        <button key={id} type="button" className="key-preset" aria-label={label} title={label} onClick={choose}>
          {picture}
        </button>
      ))}
    </div>
  );
}
