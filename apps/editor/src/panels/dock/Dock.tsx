import { type CSSProperties, type ReactNode, useLayoutEffect, useRef, useState, useSyncExternalStore } from 'react';
import { groupWith } from '../../layout/LayoutNode';
import { type PlacedGroup, placeLayout, type Rectangle } from '../../layout/placeLayout';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './dock.css';
import { DockEdge } from './DockEdge';
import { DockGroup } from './DockGroup';
import { DockPanel } from './DockPanel';
import { TAB_HEIGHT } from './TabStrip';
import { type TabDrag, useTabDrag } from './useTabDrag';

/** The style of a rectangle of the dock. */
export const styleOf = ({ x, y, width, height }: Rectangle): Record<string, number> => ({
  left: x,
  top: y,
  width,
  height,
});

/**
 * The panels. Each lies in the dock itself, not within its group, so that one that is moved elsewhere stays what it is:
 * the picture keeps its device, a list its place.
 */
export function Dock({ children }: { children?: ReactNode }): ReactNode {
  const place = useRef<HTMLElement>(null);
  const [size, setSize] = useState<readonly [number, number] | null>(null);
  useLayoutEffect(() => {
    const element = place.current!;
    const measure = (): void => setSize([element.clientWidth, element.clientHeight]);
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    measure();
    return () => observer.disconnect();
  }, []);
  const { panels, layout: panelLayout } = useEditor();
  useSignal(panels.changed);
  const layout = useSyncExternalStore(panelLayout.subscribe, panelLayout.current);
  const maximised = useSyncExternalStore(panelLayout.subscribe, panelLayout.maximised);
  const [width, height] = size ?? [0, 0];
  const all = placeLayout(layout, width, height);
  const alone = maximised === null ? undefined : groupWith(layout, maximised);
  const placed = alone ? { groups: [{ group: alone, rectangle: { x: 0, y: 0, width, height } }], edges: [] } : all;
  const drag = useTabDrag(place, placed.groups);
  return (
    <main ref={place} className="dock" style={pictureStyle(placed.groups, height)}>
      {size !== null && (
        <>
          {placed.groups.map(({ group, rectangle }) => (
            <DockGroup key={group.id} group={group} rectangle={rectangle} groups={placed.groups} onDrag={drag.begin} />
          ))}
          {all.groups.flatMap(({ group }) => {
            const shown = placed.groups.find((each) => each.group.id === group.id);
            return group.panels.map((id) => (
              <DockPanel
                key={id}
                id={id}
                isInFront={shown !== undefined && id === group.active}
                rectangle={shown ? belowTabs(shown.rectangle) : null}
              />
            ));
          })}
          {placed.edges.map((edge) => (
            <DockEdge key={`${edge.path.join('.')}/${edge.index}`} edge={edge} layout={layout} />
          ))}
          <DropMark drag={drag.current} />
        </>
      )}
      {children}
    </main>
  );
}

/** Where the picture is, for what is shown in a corner of it: none of this while it is behind another panel. */
function pictureStyle(groups: readonly PlacedGroup[], height: number): CSSProperties | undefined {
  const rectangle = groups.find(({ group }) => group.active === 'viewport')?.rectangle;
  if (!rectangle) return undefined;
  return {
    '--picture-left': `${rectangle.x}px`,
    '--picture-bottom': `${height - rectangle.y - rectangle.height}px`,
    '--picture-width': `${rectangle.width}px`,
  } as CSSProperties;
}

const belowTabs = ({ x, y, width, height }: Rectangle): Rectangle => ({
  x,
  y: y + TAB_HEIGHT,
  width,
  height: Math.max(0, height - TAB_HEIGHT),
});

/** Where a dragged tab would come to be. */
function DropMark({ drag }: { drag: TabDrag | null }): ReactNode {
  if (!drag?.mark) return null;
  return <div className="drop-mark" style={styleOf(drag.mark)} />;
}
