import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import './overlay.css';

/** Colour scale of the debug views for light count and overdraw. @param view - the view that is shown */
export function HeatScale({ view }: { readonly view: string }): ReactNode {
  const { viewport } = useEditor();
  const { heatMapMaximum } = viewport.farol;
  const marks = [0, 0.25, 0.5, 0.75, 1].map((part) => Math.round(part * heatMapMaximum));
  return (
    <figure
      className="heat-scale"
      aria-label={t('Scale: from 0, black, to {heatMapMaximum} and more, red', { heatMapMaximum })}
    >
      <figcaption>{view === 'overdraw' ? t('Draws a pixel') : t('Lights a pixel')}</figcaption>
      <div className="heat-colours" />
      <div className="heat-marks">
        {marks.map((mark, i) => (
          // oxlint-disable-next-line react/no-array-index-key -- the marks have fixed places
          <span key={i}>{i === 4 ? `${mark}+` : mark}</span>
        ))}
      </div>
    </figure>
  );
}
