/** A device's cores beyond these are better left to others. */
export const mostCores = 4;

/** How many threads may help each of so many that solve at once. */
export const helpersFor = (cores: number, solving = 1): number =>
  Math.max(0, Math.floor(Math.min(mostCores, cores) / solving) - 1);
