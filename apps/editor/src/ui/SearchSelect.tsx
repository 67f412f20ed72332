import { t } from '@farol/editing';
import { Combobox } from '@base-ui/react/combobox';
import type { ReactNode } from 'react';
import { Icon } from './Icon';
import { IconButton } from './IconButton';

export interface SearchOption {
  readonly value: string;
  readonly label: string;
}

interface SearchSelectProps {
  readonly value: string | null;
  readonly options: readonly SearchOption[];
  /** Text shown when nothing is chosen. */
  readonly placeholder: string;
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  /** Thumbnail before an option's name. */
  pictureOf?(option: SearchOption): ReactNode;
  onChange(value: string | null): void;
}

/** Chooses one of many values, or none, by typing a part of its name. */
export function SearchSelect(props: SearchSelectProps): ReactNode {
  const { value, options, placeholder, label, description, disabled, pictureOf, onChange } = props;
  const current = value === null ? null : (options.find((option) => option.value === value) ?? { value, label: value });
  return (
    <Combobox.Root
      items={options}
      value={current}
      limit={200}
      disabled={disabled}
      autoHighlight
      isItemEqualToValue={(a: SearchOption, b: SearchOption) => a.value === b.value}
      onValueChange={(next) => onChange(next?.value ?? null)}
    >
      <div className="search-select">
        <Combobox.Trigger className="select" aria-label={label} aria-description={description}>
          {current && pictureOf && <span className="option-picture">{pictureOf(current)}</span>}
          <span className="select-value one-line">{current?.label ?? placeholder}</span>
          <Icon name="down" size={12} />
        </Combobox.Trigger>
        {current && !disabled && (
          <IconButton
            icon="close"
            label={t('Clear {label}', { label })}
            title={t('Clear')}
            onClick={() => onChange(null)}
          />
        )}
      </div>
      <Combobox.Portal>
        <Combobox.Positioner className="positioner" sideOffset={3} align="end">
          <Combobox.Popup className="popup search-popup" aria-label={label}>
            <Combobox.Input className="input" placeholder={t('Search')} aria-label={t('Search: {label}', { label })} />
            <Combobox.Empty className="menu-empty">
              {options.length === 0 ? t('There are none yet.') : t('Nothing matches the search.')}
            </Combobox.Empty>
            <Combobox.List className="menu-list">
              {(option: SearchOption) => (
                <Combobox.Item key={option.value} value={option} className="menu-item">
                  <span className="menu-check">
                    <Combobox.ItemIndicator>
                      <Icon name="check" size={12} />
                    </Combobox.ItemIndicator>
                  </span>
                  {pictureOf && <span className="option-picture">{pictureOf(option)}</span>}
                  <span className="menu-text">{option.label}</span>
                </Combobox.Item>
              )}
            </Combobox.List>
          </Combobox.Popup>
        </Combobox.Positioner>
      </Combobox.Portal>
    </Combobox.Root>
  );
}
