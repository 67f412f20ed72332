import { Menu } from '@base-ui/react/menu';
import type { ReactNode } from 'react';
import { Icon } from './Icon';
import { keyText } from './keyText';
import type { MenuEntry } from '../api/MenuEntry';

/** The lines of a menu; submenus open beside it. */
export function MenuItems({ entries }: { entries: readonly MenuEntry[] }): ReactNode {
  return entries.map((entry, i) => {
    // oxlint-disable-next-line react/no-array-index-key -- lines between groups have nothing of their own
    if (entry === 'separator') return <Menu.Separator key={i} className="menu-line" />;
    if ('entries' in entry) return <Submenu key={entry.label} {...entry} />;
    return (
      <Menu.Item key={entry.label} className="menu-item" disabled={entry.disabled} onClick={entry.run}>
        <span className="menu-check">{entry.icon && <Icon name={entry.icon} size={14} />}</span>
        <span className="menu-text">
          {entry.label}
          {entry.help && <span className="menu-help">{entry.help}</span>}
        </span>
        {entry.keys && <kbd className="menu-keys">{keyText(entry.keys)}</kbd>}
      </Menu.Item>
    );
  });
}

function Submenu({ label, icon, entries }: Extract<MenuEntry, { entries: unknown }>): ReactNode {
  return (
    <Menu.SubmenuRoot>
      <Menu.SubmenuTrigger className="menu-item">
        <span className="menu-check">{icon && <Icon name={icon} size={14} />}</span>
        <span className="menu-text">{label}</span>
        <Icon name="chevron" size={12} />
      </Menu.SubmenuTrigger>
      <Menu.Portal>
        <Menu.Positioner className="positioner" sideOffset={2} alignOffset={-5}>
          <Menu.Popup className="popup">
            <MenuItems entries={entries} />
          </Menu.Popup>
        </Menu.Positioner>
      </Menu.Portal>
    </Menu.SubmenuRoot>
  );
}
