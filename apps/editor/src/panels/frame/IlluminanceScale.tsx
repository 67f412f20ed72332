import { formatCount, t } from '@farol/editing';
import type { ReactNode } from 'react';
import { illuminanceStops } from '../../viewport/illuminance/scale';
import './overlay.css';

/** Colour scale of the display of illuminance. */
export function IlluminanceScale(): ReactNode {
  return (
    <figure className="heat-scale illuminance-scale" aria-label={t('Scale: from 0.1 lux, blue, to 100,000 lux, red')}>
      <figcaption>{t('Lux on surfaces')}</figcaption>
      <div
        className="heat-colours"
        style={{ background: `linear-gradient(to right, ${illuminanceStops.map(([, colour]) => colour).join(', ')})` }}
      />
      <div className="heat-marks">
        {illuminanceStops.map(([illuminance]) => (
          <span key={illuminance}>{illuminance < 1000 ? illuminance : `${formatCount(illuminance / 1000)}k`}</span>
        ))}
      </div>
    </figure>
  );
}
