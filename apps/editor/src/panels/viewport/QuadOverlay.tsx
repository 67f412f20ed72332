import { t } from '@farol/editing';
import { type ReactNode, useSyncExternalStore } from 'react';
import { sideName, sides } from '../../actions/viewpoint';
import { useEditor } from '../../ui/EditorContext';
import { PaneEdges } from './PaneEdges';
import type { ViewPane } from '../../viewport/panes/ViewPane';
import type { Viewport } from '../../viewport/Viewport';

/** Cosine from which a view direction counts as axis-aligned. */
const SAME = 0.99999;

/** Name of a view: its side, its projection, or its camera. */
function nameOf(viewport: Viewport, { name, editorCamera }: ViewPane): string {
  if (name === 'main' && viewport.lookThrough) return viewport.lookThrough.gameObject.name;
  if (!editorCamera.orthographic) return t('Perspective');
  const { elements } = editorCamera.perspective.matrixWorld;
  const side = sides.find(([, [x, y, z]]) => x * elements[8] + y * elements[9] + z * elements[10] > SAME);
  return side ? sideName(side[0]) : t('Orthographic');
}

const textOf = (viewport: Viewport): string =>
  viewport.panes.list
    .map((pane) => {
      const { x, y, width, height } = pane.rectangle;
      return [pane === viewport.panes.active ? 1 : 0, x, y, width, height, nameOf(viewport, pane)].join('\t');
    })
    .join('\n');

/** Names of the four views; the active one is highlighted. */
export function QuadOverlay(): ReactNode {
  const { viewport } = useEditor();
  const text = useSyncExternalStore(viewport.drawn.subscribe, () => textOf(viewport));
  const names = text.split('\n').map((line, i) => {
    const [active, left, top, width, height, name] = line.split('\t');
    const place = { left: Number(left), top: Number(top), width: Number(width), height: Number(height) };
    return (
      // oxlint-disable-next-line react/no-array-index-key -- the views have fixed places
      <div key={i} className="view-pane" data-active={active === '1' || undefined} style={place}>
        <span>{name}</span>
      </div>
    );
  });
  return (
    <>
      {names}
      <PaneEdges />
    </>
  );
}
