import {
  type CSSProperties,
  lazy,
  type ReactNode,
  Suspense,
  useLayoutEffect,
  useRef,
  useState,
  useSyncExternalStore,
} from 'react';
import { groupWith, MAIN_PANEL } from '../../layout/LayoutNode';
import { placeLayout, type Rectangle } from '../../layout/placeLayout';
import { isSmallWindow, placeSheet } from '../../layout/smallWindow';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './dock.css';
import { DockEdge } from './DockEdge';
import { DockGroup } from './DockGroup';
import { DockPanel } from './DockPanel';
import { TAB_HEIGHT } from './tabHeight';

const SmallWindow = lazy(async () => ({ default: (await import('./SmallWindow')).SmallWindow }));

/** CSS position and size of a rectangle of the dock. */
export const styleOf = ({ x, y, width, height }: Rectangle): Record<string, number> => ({
  left: x,
  top: y,
  width,
  height,
});

/**
 * Container of the panels. Each is a child of the dock, not of its group, so that moving it does not remount it: the
 * viewport keeps its GL context, a list its scroll position.
 */
export function Dock({ children }: { children?: ReactNode }): ReactNode {
  const { panels, layout: panelLayout } = useEditor();
  const place = useRef<HTMLElement>(null);
  const [mark, setMark] = useState<Rectangle | null>(null);
  const [size, setSize] = useState<readonly [number, number] | null>(null);
  useLayoutEffect(() => {
    const element = place.current!;
    const measure = (): void => {
      panelLayout.setSmall(isSmallWindow(innerWidth, innerHeight));
      setSize([element.clientWidth, element.clientHeight]);
    };
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    measure();
    return () => observer.disconnect();
  }, [panelLayout]);
  useSignal(panels.changed);
  const { subscribe } = panelLayout;
  const layout = useSyncExternalStore(subscribe, panelLayout.current);
  const maximised = useSyncExternalStore(subscribe, panelLayout.maximised);
  const isSmall = useSyncExternalStore(subscribe, panelLayout.isSmall);
  const open = useSyncExternalStore(subscribe, panelLayout.sheet);
  const share = useSyncExternalStore(subscribe, panelLayout.share);
  const [width, height] = size ?? [0, 0];
  const sheet = open !== null && maximised === null && panels.get(open) ? open : null;
  const small = isSmall ? placeSheet(width, height, sheet === null ? null : share) : null;
  const all = placeLayout(layout, width, height);
  const alone = maximised === null ? undefined : groupWith(layout, maximised);
  const placed = small
    ? { groups: [], edges: [] }
    : alone
      ? { groups: [{ group: alone, rectangle: { x: 0, y: 0, width, height } }], edges: [] }
      : all;
  const shown = small
    ? panels.list.map(({ id }) => {
        const rectangle = id === MAIN_PANEL ? small.main : id === sheet ? small.sheet : null;
        return { id, isInFront: rectangle !== null, rectangle };
      })
    : all.groups.flatMap(({ group }) => {
        const placedGroup = placed.groups.find((each) => each.group.id === group.id);
        const rectangle = placedGroup ? belowTabs(placedGroup.rectangle) : null;
        return group.panels.map((id) => ({
          id,
          isInFront: placedGroup !== undefined && id === group.active,
          rectangle,
        }));
      });
  const picture = shown.find(({ id, isInFront }) => id === 'viewport' && isInFront)?.rectangle ?? null;
  return (
    <main ref={place} className="dock" style={pictureStyle(picture, height)}>
      {size !== null && (
        <>
          {placed.groups.map(({ group, rectangle }) => (
            <DockGroup
              key={group.id}
              group={group}
              rectangle={rectangle}
              groups={placed.groups}
              place={{ dock: place, onMark: setMark }}
            />
          ))}
          {shown.map((panel) => (
            <DockPanel key={panel.id} {...panel} />
          ))}
          {placed.edges.map((edge) => (
            <DockEdge key={`${edge.path.join('.')}/${edge.index}`} edge={edge} layout={layout} />
          ))}
          {small && (
            <Suspense fallback={null}>
              <SmallWindow placed={small} sheet={sheet} share={share} width={width} height={height} />
            </Suspense>
          )}
          {mark && <div className="drop-mark" style={styleOf(mark)} />}
        </>
      )}
      {children}
    </main>
  );
}

/** Position of the viewport's lower left corner, for notices; undefined while it is behind another panel. */
function pictureStyle(rectangle: Rectangle | null, height: number): CSSProperties | undefined {
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
