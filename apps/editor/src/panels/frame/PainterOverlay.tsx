import { t } from '@farol/editing';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useRef } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { viewLabel } from '../../actions/display';
import { gridCells, LABEL } from '../../viewport/painters/gridCells';
import { gridViews, ViewsPainter } from '../../viewport/painters/ViewsPainter';
import { WipePainter } from '../../viewport/painters/WipePainter';
import { IlluminanceScale } from './IlluminanceScale';
import './overlay.css';

/** Overlay of a viewport with several images: names of the views, or the border between two techniques. */
export function PainterOverlay(): ReactNode {
  const { viewport } = useEditor();
  useSignal(viewport.changed);
  const { painter } = viewport;
  if (painter instanceof ViewsPainter) return <ViewNames />;
  if (painter instanceof WipePainter) return <WipeHandle wipe={painter} />;
  return painter?.isIlluminance ? <IlluminanceScale /> : null;
}

/** Names above the views of the grid; a click shows that view alone. */
function ViewNames(): ReactNode {
  const { viewport } = useEditor();
  useSignal(viewport.resized);
  const { width, height } = viewport.size;
  return (
    <div className="view-names">
      {gridCells(gridViews.length, width, height).map((cell, i) => (
        <button
          key={gridViews[i]}
          type="button"
          style={{ left: cell.x, top: cell.y - LABEL, width: cell.width, height: cell.height + LABEL }}
          onClick={() => {
            viewport.view = gridViews[i];
            viewport.painter = null;
          }}
        >
          {viewLabel(gridViews[i])}
        </button>
      ))}
    </div>
  );
}

function WipeHandle({ wipe }: { wipe: WipePainter }): ReactNode {
  const { viewport } = useEditor();
  const place = useRef<HTMLDivElement>(null);
  useSignal(wipe.changed);
  if (wipe.showsDifference) return null;
  const move = ({ clientX }: { clientX: number }): void => {
    const { left, width } = place.current!.getBoundingClientRect();
    wipe.at = (clientX - left) / width;
  };
  const pointerDown = (event: PointerEvent<HTMLDivElement>): void => {
    const { currentTarget: handle, pointerId } = event;
    handle.setPointerCapture(pointerId);
    handle.addEventListener('pointermove', move);
    handle.addEventListener('lostpointercapture', () => handle.removeEventListener('pointermove', move), {
      once: true,
    });
  };
  const keyDown = (event: KeyboardEvent): void => {
    const to = { ArrowLeft: wipe.at - 0.02, ArrowRight: wipe.at + 0.02, Home: 0, End: 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    wipe.at = to;
  };
  const percent = Math.round(wipe.at * 100);
  return (
    <div ref={place} className="wipe">
      <div
        className="wipe-handle"
        style={{ left: `${wipe.at * 100}%` }}
        role="slider"
        tabIndex={0}
        aria-label={t('Where the two techniques meet')}
        aria-valuenow={percent}
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuetext={`${percent}%`}
        onPointerDown={pointerDown}
        onKeyDown={keyDown}
      >
        <span className="wipe-name left">{t(viewport.farol.techniques[viewport.technique].label)}</span>
        <span className="wipe-name right">{t(viewport.farol.techniques[wipe.technique].label)}</span>
      </div>
    </div>
  );
}
