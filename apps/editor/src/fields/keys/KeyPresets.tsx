import { t } from '@farol/editing';
import type { ReactNode } from 'react';

export interface KeyPreset {
  readonly id: string;
  readonly label: string;
  readonly picture: ReactNode;
  choose(): void;
}

/** Presets of curves or gradients, as thumbnails. */
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
