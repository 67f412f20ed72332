/** A duration as `8 s`, `1 min 20 s`, `2 h 5 min`. @param ms - 0 or more */
export function formatDuration(ms: number): string {
  const seconds = Math.max(0, Math.round(ms / 1000));
  if (seconds < 60) return `${seconds} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return seconds % 60 === 0 ? `${minutes} min` : `${minutes} min ${seconds % 60} s`;
  const whole = Math.round(seconds / 60);
  return whole % 60 === 0 ? `${whole / 60} h` : `${Math.floor(whole / 60)} h ${whole % 60} min`;
}

/** An estimated duration, rounded to 10 s up to two minutes, then to minutes. @param ms - 0 or more */
export function roughDuration(ms: number): string {
  const step = ms < 20_000 ? 1000 : ms <= 120_000 ? 10_000 : 60_000;
  return formatDuration(Math.round(ms / step) * step);
}
