import { t } from '@farol/editing';
import { gameObjectOf } from '@farol/engine';
import type { View, ViewInfo, ViewTile } from '@farol/renderer';
import { type ReactNode, useEffect, useState, useSyncExternalStore } from 'react';
import { viewLabel } from '../../actions/display';
import { useEditor } from '../../ui/EditorContext';
import type { ViewPane } from '../../viewport/panes/ViewPane';
import { viewOf } from '../../viewport/shading/Shading';
import type { Viewport } from '../../viewport/Viewport';
import { HeatScale } from './HeatScale';
import './overlay.css';
import { viewMeanings } from './viewMeanings';
import { viewMend } from './viewMend';

/** Smallest width of a tile with its name inside (CSS pixels). */
const NAMED = 44;
/** Width of a pane below which its legend is folded to the view's name at first (CSS pixels). */
const WIDE = 320;

const metres = (distance: number): string => distance.toPrecision(3).replace(/\.?0+$/, '');

const lightName = ({ light }: ViewTile): string => gameObjectOf(light)?.name ?? '';

/** Full name of a tile, with the name of its light. */
function tileName(tile: ViewTile): string {
  const { label, number, count, near, far } = tile;
  const text = t(label, { number, count, near: metres(near), far: metres(far) });
  const name = lightName(tile);
  return name ? `${name}: ${text}` : text;
}

/** Label inside a tile: its light's name at the first face, the number of a slice, or its content. */
function shortName(tile: ViewTile): string {
  if (tile.light) return tile.number === 1 ? lightName(tile) : '';
  return tile.count > 1 ? String(tile.number) : t(tile.label);
}

const viewIn = (viewport: Viewport, { shading }: ViewPane): View => (viewOf(shading) ?? viewport.view) as View;

/** Everything that the overlay shows, as one text that is compared to detect changes. */
const textOf = (viewport: Viewport): string =>
  JSON.stringify(
    viewport.panes.list.map((pane) => [
      viewIn(viewport, pane),
      pane.rectangle,
      pane.shown?.problem,
      pane.shown?.tiles.map((tile) => [tile.x, tile.y, tile.width, tile.height, tileName(tile)]),
    ]),
  );

/** Legend of debug views, in each pane: scales, names of tiles, and a button that creates a missing buffer. */
export function ViewOverlay(): ReactNode {
  const { viewport } = useEditor();
  useSyncExternalStore(viewport.drawn.subscribe, () => textOf(viewport));
  return viewport.panes.list.map((pane) => {
    const { x, y, width, height } = pane.rectangle;
    const view = viewIn(viewport, pane);
    const isCount = view === 'light-count' || view === 'overdraw';
    return (
      <div
        key={pane.name}
        className="pane-overlay"
        data-quad={viewport.isQuad || undefined}
        style={{ left: x, top: y, width, height }}
      >
        {isCount && <HeatScale view={view} />}
        {pane.shown?.problem && <Lacking view={view} problem={pane.shown.problem} />}
        {pane.shown && !pane.shown.problem && <BufferLegend pane={pane} info={pane.shown} />}
      </div>
    );
  });
}

/** Sentence on a buffer that the frame does not have, and a button that creates it. */
function Lacking({ view, problem }: { readonly view: View; readonly problem: string }): ReactNode {
  const mend = viewMend(useEditor(), view);
  return (
    <div className="view-lacking" role="status">
      <p>{t(problem)}</p>
      {mend && (
        <button type="button" className="button" onClick={mend.run}>
          {mend.label}
        </button>
      )}
    </div>
  );
}

/** Names of a view's tiles, and the meaning of the view; the tile under the pointer is named in full. */
function BufferLegend({ pane, info }: { readonly pane: ViewPane; readonly info: ViewInfo }): ReactNode {
  const { viewport } = useEditor();
  const [pointer, setPointer] = useState<readonly [number, number] | null>(null);
  useEffect(() => {
    const { canvas } = viewport;
    const moved = ({ clientX, clientY }: PointerEvent): void => {
      const { left, top, width, height } = pane.bounds;
      setPointer([(clientX - left) / width, (clientY - top) / height]);
    };
    const left = (): void => setPointer(null);
    const end = new AbortController();
    const { signal } = end;
    canvas.addEventListener('pointermove', moved, { signal });
    canvas.addEventListener('pointerdown', moved, { signal });
    canvas.addEventListener('pointerleave', left, { signal });
    return () => end.abort();
  }, [viewport, pane]);
  const [x, y] = pointer ?? [-1, -1];
  const under = info.tiles.find(
    (tile) => x >= tile.x && y >= tile.y && x < tile.x + tile.width && y < tile.y + tile.height,
  );
  const name = viewLabel(info.view);
  const { width } = pane.rectangle;
  return (
    <>
      {info.tiles.map((tile, i) => {
        const place = { left: `${100 * tile.x}%`, top: `${100 * tile.y}%`, width: `${100 * tile.width}%` };
        return (
          // oxlint-disable-next-line react/no-array-index-key -- tiles have fixed places
          <div
            key={i}
            className="view-tile"
            style={{ ...place, height: `${100 * tile.height}%` }}
            data-under={tile === under || undefined}
          >
            {tile.width * width >= NAMED && <span>{shortName(tile)}</span>}
          </div>
        );
      })}
      <figure className="heat-scale buffer-legend" aria-label={name}>
        <details open={width >= WIDE}>
          <summary>{name}</summary>
          {viewMeanings[info.view]?.()}
          {info.fullMotion > 0 && (
            <div className="motion-scale">
              <div className="motion-wheel" />
              {t('Full colour: {pixels} pixels a frame and more', { pixels: info.fullMotion })}
            </div>
          )}
          {info.tiles.length > 0 && (
            <div className="view-under">{under ? tileName(under) : t('Point at a part to see what it is.')}</div>
          )}
        </details>
      </figure>
    </>
  );
}
