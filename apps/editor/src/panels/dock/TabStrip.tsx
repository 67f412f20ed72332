import { t } from '@farol/editing';
import { ContextMenu } from '@base-ui/react/context-menu';
import { type KeyboardEvent, type ReactNode, useLayoutEffect, useRef, useSyncExternalStore } from 'react';
import type { DropSide, PanelGroup } from '../../layout/LayoutNode';
import type { PlacedGroup } from '../../layout/placeLayout';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { LateItems } from '../../ui/MenuButton';
import { dropTowards } from './dropTowards';
import { tabEntries } from './tabEntries';
import { type DragPlace, useTabDrag } from './useTabDrag';

const towards: Readonly<Record<string, Exclude<DropSide, 'centre'>>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'top',
  ArrowDown: 'bottom',
};

interface TabStripProps {
  readonly group: PanelGroup;
  readonly groups: readonly PlacedGroup[];
  readonly place: DragPlace;
}

/** Focuses a moved tab, once it is rendered at its new place. */
function focusTab(panel: string): void {
  requestAnimationFrame(() => document.getElementById(`tab-${panel}`)?.focus());
}

/** Reduces inactive tabs to icons when their titles do not fit. */
function fitTabs(list: HTMLElement): void {
  list.dataset.icons = 'false';
  list.dataset.icons = String(list.scrollWidth > list.clientWidth);
}

/**
 * The tabs of a group. Arrow keys focus the next tab, Alt+Shift and an arrow key moves the panel, Delete closes it; the
 * context menu offers these too.
 */
export function TabStrip({ group, groups, place }: TabStripProps): ReactNode {
  const editor = useEditor();
  const { panels, layout } = editor;
  const { panels: ids, active } = group;
  const beginDrag = useTabDrag(groups, place);
  const list = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => fitTabs(list.current!));
  const maximised = useSyncExternalStore(layout.subscribe, layout.maximised);
  const title = t(panels.get(active)?.title ?? active);
  const maximiseLabel = maximised === null ? t('Maximise {title}', { title }) : t('Give the window back');
  const keyDown = (event: KeyboardEvent, panel: string): void => {
    const side = towards[event.key];
    if (event.altKey && event.shiftKey && side) {
      const drop = dropTowards(groups, panel, side);
      if (drop) layout.move(panel, drop);
      focusTab(panel);
    } else if (event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
    else if (event.key === 'Delete') layout.close(panel);
    else {
      const at = ids.indexOf(panel);
      const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: ids.length - 1 }[event.key];
      if (to === undefined) return;
      const next = ids[(to + ids.length) % ids.length];
      layout.open(next);
      focusTab(next);
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div className="tabs">
      <div ref={list} className="tab-list" role="tablist" aria-label={t('Panels with {title}', { title })}>
        {ids.map((id) => {
          const panel = panels.get(id);
          if (!panel) return null;
          const isActive = id === active;
          return (
            <ContextMenu.Root key={id}>
              <ContextMenu.Trigger
                id={`tab-${id}`}
                className="tab"
                role="tab"
                aria-selected={isActive}
                aria-controls={isActive ? `panel-${id}` : undefined}
                tabIndex={isActive ? 0 : -1}
                data-panel={id}
                title={t('{title}: drag it elsewhere; right button: menu', { title: t(panel.title) })}
                onPointerDown={(event) => beginDrag(id, event)}
                onClick={() => layout.open(id)}
                onDoubleClick={() => layout.maximise(maximised === null ? id : null)}
                onAuxClick={(event) => event.button === 1 && layout.close(id)}
                onKeyDown={(event) => keyDown(event, id)}
              >
                <Icon name={panel.icon} size={14} />
                <span>{t(panel.title)}</span>
              </ContextMenu.Trigger>
              <ContextMenu.Portal>
                <ContextMenu.Positioner className="positioner">
                  <ContextMenu.Popup className="popup">
                    <LateItems entries={() => tabEntries(editor, panel, groups, maximised !== null)} />
                  </ContextMenu.Popup>
                </ContextMenu.Positioner>
              </ContextMenu.Portal>
            </ContextMenu.Root>
          );
        })}
      </div>
      <IconButton
        icon="maximise"
        className="button small tab-maximise"
        label={maximiseLabel}
        aria-pressed={maximised !== null}
        onClick={() => layout.maximise(maximised === null ? active : null)}
      />
    </div>
  );
}
