import { Menu } from '@base-ui/react/menu';
import { Menubar } from '@base-ui/react/menubar';
import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { menuEntries, menuLabel, menuNames } from '../../actions/menuEntries';
import { useEditor } from '../../ui/EditorContext';
import type { MenuEntry } from '../../api/MenuEntry';
import { LateItems, MenuButton } from '../../ui/MenuButton';
import { useMedia } from '../../ui/useMedia';

/** Menus of all actions. Arrow keys go from one to the next; F10 focuses the bar. A narrow window has one button for all. */
export function MenuBar(): ReactNode {
  const editor = useEditor();
  const isNarrow = useMedia('(max-width: 699px)');
  if (isNarrow) {
    const menus = (): MenuEntry[] =>
      menuNames.map((name) => ({ label: menuLabel(name), entries: menuEntries(editor, name) }));
    return <MenuButton label={t('Menus')} icon="menu" iconOnly className="button menu-bar" entries={menus} />;
  }
  return (
    <Menubar className="menu-bar" aria-label={t('Menus')}>
      {menuNames.map((name) => (
        <Menu.Root key={name}>
          <Menu.Trigger className="button">{menuLabel(name)}</Menu.Trigger>
          <Menu.Portal>
            <Menu.Positioner className="positioner" sideOffset={3} align="start">
              <Menu.Popup className="popup">
                <LateItems entries={() => menuEntries(editor, name)} />
              </Menu.Popup>
            </Menu.Positioner>
          </Menu.Portal>
        </Menu.Root>
      ))}
    </Menubar>
  );
}
