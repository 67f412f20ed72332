import { t } from '@farol/editing';
import type { InputHTMLAttributes, ReactNode } from 'react';

interface SearchInputProps extends InputHTMLAttributes<HTMLInputElement> {
  readonly value: string;
  readonly label: string;
  onSearch(query: string): void;
}

/** A search field; its placeholder is "Search" unless another one is given. */
export function SearchInput({ label, onSearch, ...rest }: SearchInputProps): ReactNode {
  return (
    <input
      className="input"
      type="search"
      aria-label={label}
      placeholder={t('Search')}
      onChange={(event) => onSearch(event.target.value)}
      {...rest}
    />
  );
}
