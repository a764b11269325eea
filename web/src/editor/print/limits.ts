/** Sides of a repeat that can be printed and sewn. [cm] */
export const leastRepeat = 0.2;
export const mostRepeat = 200;
