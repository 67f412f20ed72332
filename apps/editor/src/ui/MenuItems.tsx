import { Menu } from '@base-ui/react/menu';
import type { ReactNode } from 'react';
import { Icon } from './Icon';
import { keyText } from './keyText';
import type { MenuEntry } from '../api/MenuEntry';
import type { IconName } from '../style/iconPaths';

type MenuLine = Extract<MenuEntry, { run(): void }>;

/** The entries of a menu; submenus open beside the menu. */
export function MenuItems({ entries }: { entries: readonly MenuEntry[] }): ReactNode {
  return entries.map((entry, i) => {
    // oxlint-disable-next-line react/no-array-index-key -- separators are identified by their place
    if (entry === 'separator') return <Menu.Separator key={i} className="menu-line" />;
    if ('entries' in entry) return <Submenu key={entry.label} {...entry} />;
    const { label, checked, disabled, run } = entry;
    if (checked === undefined) {
      return (
        <Menu.Item key={label} className="menu-item" disabled={disabled} onClick={run}>
          <Line entry={entry} icon={entry.icon} />
        </Menu.Item>
      );
    }
    return (
      <Menu.CheckboxItem
        key={label}
        className="menu-item"
        checked={checked}
        disabled={disabled}
        closeOnClick
        onClick={run}
      >
        <Line entry={entry} icon={checked ? 'check' : undefined} />
      </Menu.CheckboxItem>
    );
  });
}

function Line({ entry, icon }: { entry: MenuLine; icon?: IconName }): ReactNode {
  return (
    <>
      <span className="menu-check">{icon && <Icon name={icon} size={14} />}</span>
      <span className="menu-text">
        {entry.label}
        {entry.help && <span className="menu-help">{entry.help}</span>}
      </span>
      {entry.keys && <kbd className="menu-keys">{keyText(entry.keys)}</kbd>}
    </>
  );
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
