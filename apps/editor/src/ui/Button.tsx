import type { ButtonHTMLAttributes, ReactNode } from 'react';
import type { IconName } from '../style/iconPaths';
import { Icon } from './Icon';

interface ButtonProps extends ButtonHTMLAttributes<HTMLButtonElement> {
  readonly label: string;
  readonly icon?: IconName;
  /** Appearance of the button; 'framed' when absent. */
  readonly look?: 'framed' | 'primary' | 'small' | 'small framed';
}

/** A button with a text, and an icon before it if there is one. */
export const Button = ({ label, icon, look = 'framed', ...attributes }: ButtonProps): ReactNode => (
  <button type="button" className={`button ${look}`} {...attributes}>
    {icon && <Icon name={icon} size={look === 'small' ? 12 : undefined} />}
    {icon && look !== 'small' ? <span>{label}</span> : label}
  </button>
);
