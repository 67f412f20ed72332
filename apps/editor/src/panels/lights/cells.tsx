import { formatNumber, splitColour, t } from '@farol/editing';
import type { Vector3Tuple } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';

interface SwitchProps {
  /** Accessible name. */
  readonly label: string;
  readonly isOn: boolean;
  readonly tabIndex: number;
  onChange(isOn: boolean): void;
}

/** A cell with a check box. */
export const CheckCell = ({ label, isOn, tabIndex, onChange }: SwitchProps): ReactNode => (
  <span role="gridcell">
    <button
      type="button"
      role="checkbox"
      className="checkbox"
      aria-checked={isOn}
      aria-label={label}
      tabIndex={tabIndex}
      onClick={() => onChange(!isOn)}
    >
      {isOn && (
        <span className="checkbox-mark">
          <Icon name="check" size={12} />
        </span>
      )}
    </button>
  </span>
);

/** A cell with the switch that shows lights alone. */
export const SoloCell = ({
  name,
  isOn,
  tabIndex,
  onChange,
}: Omit<SwitchProps, 'label'> & { name: string }): ReactNode => (
  <span role="gridcell">
    <button
      type="button"
      className="button small"
      aria-pressed={isOn}
      aria-label={t('Solo of {name}', { name })}
      tabIndex={tabIndex}
      onClick={() => onChange(!isOn)}
    >
      S
    </button>
  </span>
);

interface ColourCellProps {
  readonly label: string;
  readonly colour: Vector3Tuple;
  /** Text beside the colour, such as its temperature. */
  readonly text?: string;
  readonly tabIndex: number;
  onPick(anchor: HTMLElement): void;
}

/** A cell with a colour, which opens the picker. */
export function ColourCell({ label, colour, text = '', tabIndex, onPick }: ColourCellProps): ReactNode {
  const { hex } = splitColour(colour);
  return (
    <span role="gridcell">
      <button
        type="button"
        className="lights-text"
        aria-label={`${label}: ${text || hex}`}
        tabIndex={tabIndex}
        onClick={({ currentTarget }) => onPick(currentTarget)}
      >
        <span className="swatch" style={{ background: hex }} />
        {text && <span className="dim">{text}</span>}
      </button>
    </span>
  );
}

/** A cell with a share of the lighting time. @param cost - 0 to 1 */
export const CostCell = ({ cost }: { readonly cost: number }): ReactNode => (
  <span role="gridcell" className="lights-cost">
    {`${formatNumber(Math.round(1000 * cost) / 10, 'short')} %`}
  </span>
);
