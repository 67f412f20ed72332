import { Menu } from '@base-ui/react/menu';
import type { ReactNode } from 'react';
import { Icon } from './Icon';
import type { IconName } from '../style/iconPaths';
import type { MenuEntry } from '../api/MenuEntry';
import { MenuItems } from './MenuItems';

interface MenuButtonProps {
  readonly label: string;
  readonly icon?: IconName;
  /** Whether only the icon is shown; the label is then the accessible name. */
  readonly iconOnly?: boolean;
  readonly className?: string;
  readonly disabled?: boolean;
  /** Entries of the menu; called when it opens. */
  entries(): readonly MenuEntry[];
}

export function MenuButton(props: MenuButtonProps): ReactNode {
  const { label, icon, iconOnly = false, className = 'button', disabled, entries } = props;
  return (
    <Menu.Root>
      <Menu.Trigger
        className={className}
        aria-label={iconOnly ? label : undefined}
        title={iconOnly ? label : undefined}
        disabled={disabled}
      >
        {icon && <Icon name={icon} />}
        {!iconOnly && <span>{label}</span>}
        {!iconOnly && <Icon name="down" size={12} />}
      </Menu.Trigger>
      <Menu.Portal>
        <Menu.Positioner className="positioner" sideOffset={3} align="start">
          <Menu.Popup className="popup">
            <LateItems entries={entries} />
          </Menu.Popup>
        </Menu.Positioner>
      </Menu.Portal>
    </Menu.Root>
  );
}

/** Calls `entries` only while the menu is open. */
export function LateItems({ entries }: { entries(): readonly MenuEntry[] }): ReactNode {
  return <MenuItems entries={entries()} />;
}
