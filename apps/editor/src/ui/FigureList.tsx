import type { ReactNode } from 'react';

interface FigureListProps {
  readonly className?: string;
  readonly label?: string;
  /** Names with their values, which are texts. */
  readonly figures: readonly (readonly [name: string, value: string])[];
}

/** A list of figures: a name and a value in each line. */
export const FigureList = ({ className, label, figures }: FigureListProps): ReactNode => (
  <dl className={className} aria-label={label}>
    {figures.map(([name, value]) => (
      <div key={name}>
        <dt>{name}</dt>
        <dd>{value}</dd>
      </div>
    ))}
  </dl>
);
