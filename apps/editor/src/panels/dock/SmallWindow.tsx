import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useEffect } from 'react';
import { MAIN_PANEL } from '../../layout/LayoutNode';
import type { Rectangle } from '../../layout/placeLayout';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { SheetEdge, type SheetEdgeProps } from './SheetEdge';

interface SheetTabsProps {
  readonly rectangle: Rectangle;
  /** Id of the panel beside the viewport; null for none. */
  readonly sheet: string | null;
}

/** Divider and tabs of a small window, where the viewport has at most one panel beside it. */
export const SmallWindow = ({ sheet, ...edge }: SheetEdgeProps & Pick<SheetTabsProps, 'sheet'>): ReactNode => (
  <>
    <SheetEdge {...edge} />
    <SheetTabs rectangle={edge.placed.tabs} sheet={sheet} />
  </>
);

/** Tabs of a small window; pressing the open one closes its panel. */
function SheetTabs({ rectangle, sheet }: SheetTabsProps): ReactNode {
  const { panels, layout } = useEditor();
  const { x, y, width, height } = rectangle;
  const active = sheet ?? MAIN_PANEL;
  const list = panels.list.toSorted((a, b) => Number(b.id === MAIN_PANEL) - Number(a.id === MAIN_PANEL));
  useEffect(() => {
    document.getElementById(`tab-${active}`)?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }, [active]);
  const keyDown = (event: KeyboardEvent, at: number): void => {
    const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: list.length - 1 }[event.key];
    if (to === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    const { id } = list[(to + list.length) % list.length];
    layout.open(id);
    requestAnimationFrame(() => document.getElementById(`tab-${id}`)?.focus());
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div className="sheet-tabs" role="tablist" aria-label={t('Panels')} style={{ left: x, top: y, width, height }}>
      {list.map(({ id, title, icon }, i) => (
        <button
          key={id}
          type="button"
          id={`tab-${id}`}
          className="sheet-tab"
          role="tab"
          aria-selected={id === active}
          aria-controls={id === active ? `panel-${id}` : undefined}
          tabIndex={id === active ? 0 : -1}
          onClick={() => layout.open(id === sheet ? MAIN_PANEL : id)}
          onKeyDown={(event) => keyDown(event, i)}
        >
          <Icon name={icon} size={18} />
          <span>{t(title)}</span>
        </button>
      ))}
    </div>
  );
}
