/** Greatest number of cores to use; more are better left to other programs. */
export const mostCores = 4;

/** Number of threads that may help each of `solving` simultaneous solves. */
export const helpersFor = (cores: number, solving = 1): number =>
  Math.max(0, Math.floor(Math.min(mostCores, cores) / solving) - 1);
