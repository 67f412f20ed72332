import { t } from '@farol/editing';
import { Select } from '../Select';
import { NumberField } from './NumberField';

const sizes = ['640 × 360', '1280 × 720', '1920 × 1080', '2560 × 1440', '3840 × 2160'];

interface SizeFieldsProps {
  width: number;
  height: number;
  onChange(size: { width: number; height: number }): void;
}

/** Size of the picture: a common one, or any other. */
export function SizeFields({ width, height, onChange }: SizeFieldsProps) {
  const now = `${width} × ${height}`;
  const choose = (text: string): void => {
    const [width, height] = text.split(' × ').map(Number);
    if (height) onChange({ width, height });
  };
  return (
    <div class="fields thirds">
      <Select
        label={t('Picture (pixels)')}
        value={sizes.includes(now) ? now : ''}
        options={[...sizes.map((size) => [size, size] as const), ['', 'Another size']]}
        onChange={choose}
      />
      <NumberField
        label={t('Width')}
        value={width}
        min={16}
        max={8192}
        onChange={(width) => onChange({ width, height })}
      />
      <NumberField
        label={t('Height')}
        value={height}
        min={16}
        max={8192}
        onChange={(height) => onChange({ width, height })}
      />
    </div>
  );
}
