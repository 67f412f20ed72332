import { t } from '@farol/editing';
import { Combobox } from '@base-ui/react/combobox';
import { type ReactNode, useState } from 'react';
import { Icon } from './Icon';
import type { IconName } from '../style/iconPaths';

export interface SearchMenuItem {
  readonly value: string;
  readonly label: string;
  readonly help?: string;
  readonly icon?: IconName;
  readonly disabled?: boolean;
}

interface SearchMenuProps {
  readonly label: string;
  readonly icon: IconName;
  readonly className?: string;
  /** Items of the menu; called while it is open. */
  items(): readonly SearchMenuItem[];
  onChoose(value: string): void;
}

/** A button that opens a list of commands, searched by name or help text. */
export function SearchMenu(props: SearchMenuProps): ReactNode {
  const { label, icon, className = 'button', items, onChoose } = props;
  const [isOpen, setIsOpen] = useState(false);
  return (
    <Combobox.Root
      items={isOpen ? items() : []}
      value={null}
      open={isOpen}
      onOpenChange={setIsOpen}
      autoHighlight
      filter={(item: SearchMenuItem, query) => {
        const text = `${item.label} ${item.help ?? ''}`.toLowerCase();
        return query
          .toLowerCase()
          .split(/\s+/)
          .every((word) => text.includes(word));
      }}
      onValueChange={(item: SearchMenuItem | null) => {
        if (item) onChoose(item.value);
      }}
    >
      <Combobox.Trigger className={className} aria-label={label}>
        <Icon name={icon} />
        <span>{label}</span>
        <Icon name="down" size={12} />
      </Combobox.Trigger>
      <Combobox.Portal>
        <Combobox.Positioner className="positioner" sideOffset={3} align="center">
          <Combobox.Popup className="popup search-popup" aria-label={label}>
            <Combobox.Input className="input" placeholder={t('Search')} aria-label={t('Search: {label}', { label })} />
            <Combobox.Empty className="menu-empty">{t('Nothing matches the search.')}</Combobox.Empty>
            <Combobox.List className="menu-list">
              {(item: SearchMenuItem) => (
                <Combobox.Item key={item.value} value={item} disabled={item.disabled} className="menu-item">
                  <span className="menu-check">{item.icon && <Icon name={item.icon} size={14} />}</span>
                  <span className="menu-text">
                    {item.label}
                    {item.help && <span className="menu-help">{item.help}</span>}
                  </span>
                </Combobox.Item>
              )}
            </Combobox.List>
          </Combobox.Popup>
        </Combobox.Positioner>
      </Combobox.Portal>
    </Combobox.Root>
  );
}
