import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { Button } from '../../ui/Button';
import { NumberInput, type NumberInputProps } from '../../ui/NumberInput';

export type Size = readonly [number, number];

type NumberRowProps = Pick<NumberInputProps, 'label' | 'min' | 'max' | 'step' | 'unit' | 'disabled'> & {
  readonly value: number;
  onChange(value: number): void;
};

/** A number with its label; Escape discards text that was typed and not committed. */
export function NumberRow({ label, value, onChange, ...rest }: NumberRowProps): ReactNode {
  const [draft, setDraft] = useState<number | null>(null);
  return (
    <div className="setting-row">
      <span aria-hidden="true">{label}</span>
      <NumberInput
        {...rest}
        label={label}
        value={draft ?? value}
        onPreview={setDraft}
        onCommit={() => {
          if (draft !== null) onChange(draft);
          setDraft(null);
        }}
        onDiscard={() => setDraft(null)}
      />
    </div>
  );
}

interface PixelSizeProps {
  /** Choices of sizes (pixels), by name. */
  readonly offered: Readonly<Record<string, Size>>;
  readonly value: Size;
  /** Largest width and height (pixels). */
  readonly max: number;
  onChange(value: Size): void;
}

/** Size of a picture: one of the choices, or typed numbers. */
export function PixelSize({ offered, value: [width, height], max, onChange }: PixelSizeProps): ReactNode {
  const common = { min: 1, max, step: 1, unit: 'px' };
  return (
    <>
      <div className="export-row size-row">
        {Object.entries(offered).map(([label, each]) => (
          <Button
            key={label}
            label={label}
            aria-pressed={each[0] === width && each[1] === height}
            disabled={Math.max(...each) > max}
            onClick={() => onChange(each)}
          />
        ))}
      </div>
      <NumberRow
        {...common}
        label={t('Width')}
        value={width}
        onChange={(wide) => onChange([Math.round(wide), height])}
      />
      <NumberRow
        {...common}
        label={t('Height')}
        value={height}
        onChange={(high) => onChange([width, Math.round(high)])}
      />
    </>
  );
}
