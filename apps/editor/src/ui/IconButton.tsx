import type { ButtonHTMLAttributes, ReactNode } from 'react';
import type { IconName } from '../style/iconPaths';
import { Icon } from './Icon';

export interface IconButtonProps extends ButtonHTMLAttributes<HTMLButtonElement> {
  readonly icon: IconName;
  /** Name that is read aloud; the tooltip as well without a `title`. */
  readonly label: string;
  /** Side of the icon (CSS pixels). */
  readonly size?: number;
}

/** A button that shows an icon alone. */
export const IconButton = ({ icon, label, size = 12, ...attributes }: IconButtonProps): ReactNode => (
  <button type="button" className="button small" aria-label={label} title={label} {...attributes}>
    <Icon name={icon} size={size} />
  </button>
);
