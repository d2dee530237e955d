sce1.0
# Many instances of one mesh: a sunflower of 400 gems.
# The mesh of 80 triangles is kept once; each gem is the transform of its place. From one to the next
# it turns by the golden angle, 137.5 degrees: count the spirals, 21 one way and 34 the other. A
# structure over the objects finds which of them a ray can meet at all.

eyepos 0 -11 11
eyedir 0 11 -11.4
eyeup 0 0 1
wdist 1
fovy_deg 33
nx 480
ny 320
max_recursion 0
aasample 4
background 0.5 0.52 0.54

{
    translate -50 -30 60
    rotate 45 1 -1 0
    arealight 5   0.80 0.75 0.66
}
pointlight 30 -60 80   0.32 0.33 0.38

{
    ca 0.25 0.25 0.25
    cr 0.30 0.38 0.42
    triangle -60 -60 -0.4   60 -60 -0.4   60 60 -0.4
    triangle -60 -60 -0.4   60 60 -0.4   -60 60 -0.4
}
ca 0.26 0.26 0.26
cp 0.12 0.12 0.12
shininess 40
cr 0.46 0.24 0.14
push_matrix
    rotate 0.0 0 0 1
    translate 0.130 0 0.899
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 137.5 0 0 1
    translate 0.243 0 0.896
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 275.0 0 0 1
    translate 0.318 0 0.893
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 52.5 0 0 1
    translate 0.378 0 0.891
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 190.0 0 0 1
    translate 0.430 0 0.888
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 327.5 0 0 1
    translate 0.476 0 0.885
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 105.0 0 0 1
    translate 0.519 0 0.882
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 242.6 0 0 1
    translate 0.558 0 0.880
    scale 0.185 0.185 0.259
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 20.1 0 0 1
    translate 0.594 0 0.877
    scale 0.185 0.185 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 157.6 0 0 1
    translate 0.629 0 0.874
    scale 0.185 0.185 0.260
    object_flat generate:icosphere:80
pop_matrix
cr 0.48 0.25 0.14
push_matrix
    rotate 295.1 0 0 1
    translate 0.661 0 0.871
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 72.6 0 0 1
    translate 0.692 0 0.869
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 210.1 0 0 1
    translate 0.722 0 0.866
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 347.6 0 0 1
    translate 0.750 0 0.863
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 125.1 0 0 1
    translate 0.778 0 0.860
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 262.6 0 0 1
    translate 0.804 0 0.858
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 40.1 0 0 1
    translate 0.830 0 0.855
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 177.6 0 0 1
    translate 0.855 0 0.852
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 315.1 0 0 1
    translate 0.879 0 0.849
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 92.7 0 0 1
    translate 0.903 0 0.847
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
cr 0.50 0.26 0.14
push_matrix
    rotate 230.2 0 0 1
    translate 0.926 0 0.844
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 7.7 0 0 1
    translate 0.948 0 0.841
    scale 0.186 0.186 0.260
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 145.2 0 0 1
    translate 0.970 0 0.838
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 282.7 0 0 1
    translate 0.992 0 0.836
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 60.2 0 0 1
    translate 1.013 0 0.833
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 197.7 0 0 1
    translate 1.033 0 0.830
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 335.2 0 0 1
    translate 1.053 0 0.827
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 112.7 0 0 1
    translate 1.073 0 0.825
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 250.2 0 0 1
    translate 1.092 0 0.822
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 27.7 0 0 1
    translate 1.112 0 0.819
    scale 0.186 0.186 0.261
    object_flat generate:icosphere:80
pop_matrix
cr 0.52 0.28 0.14
push_matrix
    rotate 165.2 0 0 1
    translate 1.130 0 0.816
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 302.7 0 0 1
    translate 1.149 0 0.814
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 80.3 0 0 1
    translate 1.167 0 0.811
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 217.8 0 0 1
    translate 1.185 0 0.808
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 355.3 0 0 1
    translate 1.202 0 0.805
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 132.8 0 0 1
    translate 1.220 0 0.803
    scale 0.187 0.187 0.261
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 270.3 0 0 1
    translate 1.237 0 0.800
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 47.8 0 0 1
    translate 1.254 0 0.797
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 185.3 0 0 1
    translate 1.270 0 0.794
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 322.8 0 0 1
    translate 1.287 0 0.792
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
cr 0.54 0.29 0.14
push_matrix
    rotate 100.3 0 0 1
    translate 1.303 0 0.789
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 237.8 0 0 1
    translate 1.319 0 0.786
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 15.3 0 0 1
    translate 1.335 0 0.783
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 152.8 0 0 1
    translate 1.351 0 0.781
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 290.4 0 0 1
    translate 1.366 0 0.778
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 67.9 0 0 1
    translate 1.381 0 0.775
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 205.4 0 0 1
    translate 1.396 0 0.772
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 342.9 0 0 1
    translate 1.411 0 0.770
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 120.4 0 0 1
    translate 1.426 0 0.767
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 257.9 0 0 1
    translate 1.441 0 0.764
    scale 0.187 0.187 0.262
    object_flat generate:icosphere:80
pop_matrix
cr 0.56 0.30 0.14
push_matrix
    rotate 35.4 0 0 1
    translate 1.455 0 0.761
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 172.9 0 0 1
    translate 1.470 0 0.759
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 310.4 0 0 1
    translate 1.484 0 0.756
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 87.9 0 0 1
    translate 1.498 0 0.753
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 225.4 0 0 1
    translate 1.512 0 0.750
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 2.9 0 0 1
    translate 1.526 0 0.748
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 140.4 0 0 1
    translate 1.540 0 0.745
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 278.0 0 0 1
    translate 1.553 0 0.742
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 55.5 0 0 1
    translate 1.567 0 0.739
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 193.0 0 0 1
    translate 1.580 0 0.737
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
cr 0.57 0.31 0.14
push_matrix
    rotate 330.5 0 0 1
    translate 1.593 0 0.734
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 108.0 0 0 1
    translate 1.606 0 0.731
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 245.5 0 0 1
    translate 1.619 0 0.728
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 23.0 0 0 1
    translate 1.632 0 0.726
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 160.5 0 0 1
    translate 1.645 0 0.723
    scale 0.188 0.188 0.263
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 298.0 0 0 1
    translate 1.658 0 0.720
    scale 0.188 0.188 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 75.5 0 0 1
    translate 1.670 0 0.717
    scale 0.188 0.188 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 213.0 0 0 1
    translate 1.683 0 0.715
    scale 0.188 0.188 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 350.5 0 0 1
    translate 1.695 0 0.712
    scale 0.188 0.188 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 128.1 0 0 1
    translate 1.708 0 0.709
    scale 0.188 0.188 0.264
    object_flat generate:icosphere:80
pop_matrix
cr 0.59 0.32 0.14
push_matrix
    rotate 265.6 0 0 1
    translate 1.720 0 0.706
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 43.1 0 0 1
    translate 1.732 0 0.704
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 180.6 0 0 1
    translate 1.744 0 0.701
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 318.1 0 0 1
    translate 1.756 0 0.698
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 95.6 0 0 1
    translate 1.768 0 0.695
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 233.1 0 0 1
    translate 1.780 0 0.693
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 10.6 0 0 1
    translate 1.792 0 0.690
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 148.1 0 0 1
    translate 1.804 0 0.687
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 285.6 0 0 1
    translate 1.815 0 0.684
    scale 0.189 0.189 0.264
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 63.1 0 0 1
    translate 1.827 0 0.682
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
cr 0.61 0.33 0.14
push_matrix
    rotate 200.6 0 0 1
    translate 1.838 0 0.679
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 338.1 0 0 1
    translate 1.850 0 0.676
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 115.7 0 0 1
    translate 1.861 0 0.673
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 253.2 0 0 1
    translate 1.872 0 0.671
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 30.7 0 0 1
    translate 1.883 0 0.668
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 168.2 0 0 1
    translate 1.894 0 0.665
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 305.7 0 0 1
    translate 1.906 0 0.662
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 83.2 0 0 1
    translate 1.917 0 0.660
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 220.7 0 0 1
    translate 1.927 0 0.657
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 358.2 0 0 1
    translate 1.938 0 0.654
    scale 0.189 0.189 0.265
    object_flat generate:icosphere:80
pop_matrix
cr 0.63 0.35 0.14
push_matrix
    rotate 135.7 0 0 1
    translate 1.949 0 0.651
    scale 0.190 0.190 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 273.2 0 0 1
    translate 1.960 0 0.649
    scale 0.190 0.190 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 50.7 0 0 1
    translate 1.971 0 0.646
    scale 0.190 0.190 0.265
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 188.2 0 0 1
    translate 1.981 0 0.643
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 325.8 0 0 1
    translate 1.992 0 0.640
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 103.3 0 0 1
    translate 2.002 0 0.638
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 240.8 0 0 1
    translate 2.013 0 0.635
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 18.3 0 0 1
    translate 2.023 0 0.632
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 155.8 0 0 1
    translate 2.034 0 0.629
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 293.3 0 0 1
    translate 2.044 0 0.627
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
cr 0.65 0.36 0.14
push_matrix
    rotate 70.8 0 0 1
    translate 2.054 0 0.624
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 208.3 0 0 1
    translate 2.064 0 0.621
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 345.8 0 0 1
    translate 2.074 0 0.618
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 123.3 0 0 1
    translate 2.085 0 0.616
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 260.8 0 0 1
    translate 2.095 0 0.613
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 38.3 0 0 1
    translate 2.105 0 0.610
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 175.8 0 0 1
    translate 2.115 0 0.607
    scale 0.190 0.190 0.266
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 313.4 0 0 1
    translate 2.124 0 0.605
    scale 0.190 0.190 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 90.9 0 0 1
    translate 2.134 0 0.602
    scale 0.190 0.190 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 228.4 0 0 1
    translate 2.144 0 0.599
    scale 0.190 0.190 0.267
    object_flat generate:icosphere:80
pop_matrix
cr 0.67 0.37 0.14
push_matrix
    rotate 5.9 0 0 1
    translate 2.154 0 0.596
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 143.4 0 0 1
    translate 2.164 0 0.594
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 280.9 0 0 1
    translate 2.173 0 0.591
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 58.4 0 0 1
    translate 2.183 0 0.588
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 195.9 0 0 1
    translate 2.193 0 0.585
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 333.4 0 0 1
    translate 2.202 0 0.583
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 110.9 0 0 1
    translate 2.212 0 0.580
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 248.4 0 0 1
    translate 2.221 0 0.577
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 25.9 0 0 1
    translate 2.231 0 0.574
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 163.5 0 0 1
    translate 2.240 0 0.572
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
cr 0.69 0.38 0.14
push_matrix
    rotate 301.0 0 0 1
    translate 2.249 0 0.569
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 78.5 0 0 1
    translate 2.259 0 0.566
    scale 0.191 0.191 0.267
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 216.0 0 0 1
    translate 2.268 0 0.563
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 353.5 0 0 1
    translate 2.277 0 0.561
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 131.0 0 0 1
    translate 2.286 0 0.558
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 268.5 0 0 1
    translate 2.296 0 0.555
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 46.0 0 0 1
    translate 2.305 0 0.552
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 183.5 0 0 1
    translate 2.314 0 0.550
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 321.0 0 0 1
    translate 2.323 0 0.547
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 98.5 0 0 1
    translate 2.332 0 0.544
    scale 0.191 0.191 0.268
    object_flat generate:icosphere:80
pop_matrix
cr 0.71 0.39 0.14
push_matrix
    rotate 236.0 0 0 1
    translate 2.341 0 0.541
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 13.5 0 0 1
    translate 2.350 0 0.539
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 151.1 0 0 1
    translate 2.359 0 0.536
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 288.6 0 0 1
    translate 2.368 0 0.533
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 66.1 0 0 1
    translate 2.377 0 0.530
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 203.6 0 0 1
    translate 2.385 0 0.528
    scale 0.192 0.192 0.268
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 341.1 0 0 1
    translate 2.394 0 0.525
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 118.6 0 0 1
    translate 2.403 0 0.522
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 256.1 0 0 1
    translate 2.412 0 0.519
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 33.6 0 0 1
    translate 2.420 0 0.517
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
cr 0.73 0.41 0.14
push_matrix
    rotate 171.1 0 0 1
    translate 2.429 0 0.514
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 308.6 0 0 1
    translate 2.438 0 0.511
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 86.1 0 0 1
    translate 2.446 0 0.508
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 223.6 0 0 1
    translate 2.455 0 0.506
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 1.2 0 0 1
    translate 2.463 0 0.503
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 138.7 0 0 1
    translate 2.472 0 0.500
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 276.2 0 0 1
    translate 2.480 0 0.497
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 53.7 0 0 1
    translate 2.489 0 0.495
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 191.2 0 0 1
    translate 2.497 0 0.492
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 328.7 0 0 1
    translate 2.506 0 0.489
    scale 0.192 0.192 0.269
    object_flat generate:icosphere:80
pop_matrix
cr 0.75 0.42 0.14
push_matrix
    rotate 106.2 0 0 1
    translate 2.514 0 0.486
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 243.7 0 0 1
    translate 2.522 0 0.484
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 21.2 0 0 1
    translate 2.531 0 0.481
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 158.7 0 0 1
    translate 2.539 0 0.478
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 296.2 0 0 1
    translate 2.547 0 0.475
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 73.7 0 0 1
    translate 2.556 0 0.473
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 211.2 0 0 1
    translate 2.564 0 0.470
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 348.8 0 0 1
    translate 2.572 0 0.467
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 126.3 0 0 1
    translate 2.580 0 0.464
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 263.8 0 0 1
    translate 2.588 0 0.462
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
cr 0.77 0.43 0.14
push_matrix
    rotate 41.3 0 0 1
    translate 2.596 0 0.459
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 178.8 0 0 1
    translate 2.604 0 0.456
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 316.3 0 0 1
    translate 2.612 0 0.453
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 93.8 0 0 1
    translate 2.620 0 0.451
    scale 0.193 0.193 0.270
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 231.3 0 0 1
    translate 2.628 0 0.448
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 8.8 0 0 1
    translate 2.636 0 0.445
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 146.3 0 0 1
    translate 2.644 0 0.442
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 283.8 0 0 1
    translate 2.652 0 0.440
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 61.3 0 0 1
    translate 2.660 0 0.437
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 198.9 0 0 1
    translate 2.668 0 0.434
    scale 0.193 0.193 0.271
    object_flat generate:icosphere:80
pop_matrix
cr 0.79 0.44 0.14
push_matrix
    rotate 336.4 0 0 1
    translate 2.676 0 0.431
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 113.9 0 0 1
    translate 2.684 0 0.429
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 251.4 0 0 1
    translate 2.692 0 0.426
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 28.9 0 0 1
    translate 2.699 0 0.423
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 166.4 0 0 1
    translate 2.707 0 0.420
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 303.9 0 0 1
    translate 2.715 0 0.418
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 81.4 0 0 1
    translate 2.723 0 0.415
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 218.9 0 0 1
    translate 2.730 0 0.412
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 356.4 0 0 1
    translate 2.738 0 0.409
    scale 0.194 0.194 0.271
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 133.9 0 0 1
    translate 2.746 0 0.407
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
cr 0.80 0.45 0.14
push_matrix
    rotate 271.4 0 0 1
    translate 2.753 0 0.404
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 48.9 0 0 1
    translate 2.761 0 0.401
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 186.5 0 0 1
    translate 2.769 0 0.398
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 324.0 0 0 1
    translate 2.776 0 0.396
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 101.5 0 0 1
    translate 2.784 0 0.393
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 239.0 0 0 1
    translate 2.791 0 0.390
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 16.5 0 0 1
    translate 2.799 0 0.387
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 154.0 0 0 1
    translate 2.806 0 0.385
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 291.5 0 0 1
    translate 2.814 0 0.382
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 69.0 0 0 1
    translate 2.821 0 0.379
    scale 0.194 0.194 0.272
    object_flat generate:icosphere:80
pop_matrix
cr 0.82 0.47 0.14
push_matrix
    rotate 206.5 0 0 1
    translate 2.829 0 0.376
    scale 0.195 0.195 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 344.0 0 0 1
    translate 2.836 0 0.374
    scale 0.195 0.195 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 121.5 0 0 1
    translate 2.844 0 0.371
    scale 0.195 0.195 0.272
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 259.0 0 0 1
    translate 2.851 0 0.368
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 36.6 0 0 1
    translate 2.858 0 0.365
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 174.1 0 0 1
    translate 2.866 0 0.363
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 311.6 0 0 1
    translate 2.873 0 0.360
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 89.1 0 0 1
    translate 2.880 0 0.357
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 226.6 0 0 1
    translate 2.888 0 0.354
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 4.1 0 0 1
    translate 2.895 0 0.352
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
cr 0.84 0.48 0.14
push_matrix
    rotate 141.6 0 0 1
    translate 2.902 0 0.349
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 279.1 0 0 1
    translate 2.909 0 0.346
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 56.6 0 0 1
    translate 2.916 0 0.343
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 194.1 0 0 1
    translate 2.924 0 0.341
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 331.6 0 0 1
    translate 2.931 0 0.338
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 109.1 0 0 1
    translate 2.938 0 0.335
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 246.6 0 0 1
    translate 2.945 0 0.332
    scale 0.195 0.195 0.273
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 24.2 0 0 1
    translate 2.952 0 0.330
    scale 0.195 0.195 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 161.7 0 0 1
    translate 2.959 0 0.327
    scale 0.195 0.195 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 299.2 0 0 1
    translate 2.966 0 0.324
    scale 0.195 0.195 0.274
    object_flat generate:icosphere:80
pop_matrix
cr 0.86 0.49 0.14
push_matrix
    rotate 76.7 0 0 1
    translate 2.974 0 0.321
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 214.2 0 0 1
    translate 2.981 0 0.319
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 351.7 0 0 1
    translate 2.988 0 0.316
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 129.2 0 0 1
    translate 2.995 0 0.313
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 266.7 0 0 1
    translate 3.002 0 0.310
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 44.2 0 0 1
    translate 3.009 0 0.308
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 181.7 0 0 1
    translate 3.016 0 0.305
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 319.2 0 0 1
    translate 3.023 0 0.302
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 96.7 0 0 1
    translate 3.030 0 0.299
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 234.3 0 0 1
    translate 3.036 0 0.297
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
cr 0.88 0.50 0.14
push_matrix
    rotate 11.8 0 0 1
    translate 3.043 0 0.294
    scale 0.196 0.196 0.274
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 149.3 0 0 1
    translate 3.050 0 0.291
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 286.8 0 0 1
    translate 3.057 0 0.288
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 64.3 0 0 1
    translate 3.064 0 0.286
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 201.8 0 0 1
    translate 3.071 0 0.283
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 339.3 0 0 1
    translate 3.078 0 0.280
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 116.8 0 0 1
    translate 3.085 0 0.277
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 254.3 0 0 1
    translate 3.091 0 0.275
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 31.8 0 0 1
    translate 3.098 0 0.272
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 169.3 0 0 1
    translate 3.105 0 0.269
    scale 0.196 0.196 0.275
    object_flat generate:icosphere:80
pop_matrix
cr 0.88 0.52 0.16
push_matrix
    rotate 306.8 0 0 1
    translate 3.112 0 0.266
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 84.3 0 0 1
    translate 3.118 0 0.264
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 221.9 0 0 1
    translate 3.125 0 0.261
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 359.4 0 0 1
    translate 3.132 0 0.258
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 136.9 0 0 1
    translate 3.139 0 0.255
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 274.4 0 0 1
    translate 3.145 0 0.253
    scale 0.197 0.197 0.275
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 51.9 0 0 1
    translate 3.152 0 0.250
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 189.4 0 0 1
    translate 3.159 0 0.247
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 326.9 0 0 1
    translate 3.165 0 0.244
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 104.4 0 0 1
    translate 3.172 0 0.242
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
cr 0.89 0.54 0.18
push_matrix
    rotate 241.9 0 0 1
    translate 3.178 0 0.239
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 19.4 0 0 1
    translate 3.185 0 0.236
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 156.9 0 0 1
    translate 3.192 0 0.233
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 294.4 0 0 1
    translate 3.198 0 0.231
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 72.0 0 0 1
    translate 3.205 0 0.228
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 209.5 0 0 1
    translate 3.211 0 0.225
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 347.0 0 0 1
    translate 3.218 0 0.222
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 124.5 0 0 1
    translate 3.224 0 0.220
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 262.0 0 0 1
    translate 3.231 0 0.217
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 39.5 0 0 1
    translate 3.237 0 0.214
    scale 0.197 0.197 0.276
    object_flat generate:icosphere:80
pop_matrix
cr 0.89 0.56 0.20
push_matrix
    rotate 177.0 0 0 1
    translate 3.244 0 0.211
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 314.5 0 0 1
    translate 3.250 0 0.209
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 92.0 0 0 1
    translate 3.257 0 0.206
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 229.5 0 0 1
    translate 3.263 0 0.203
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 7.0 0 0 1
    translate 3.270 0 0.200
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 144.5 0 0 1
    translate 3.276 0 0.198
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 282.0 0 0 1
    translate 3.283 0 0.195
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 59.6 0 0 1
    translate 3.289 0 0.192
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 197.1 0 0 1
    translate 3.295 0 0.189
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 334.6 0 0 1
    translate 3.302 0 0.187
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
cr 0.89 0.58 0.22
push_matrix
    rotate 112.1 0 0 1
    translate 3.308 0 0.184
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 249.6 0 0 1
    translate 3.314 0 0.181
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 27.1 0 0 1
    translate 3.321 0 0.178
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 164.6 0 0 1
    translate 3.327 0 0.176
    scale 0.198 0.198 0.277
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 302.1 0 0 1
    translate 3.333 0 0.173
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 79.6 0 0 1
    translate 3.340 0 0.170
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 217.1 0 0 1
    translate 3.346 0 0.167
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 354.6 0 0 1
    translate 3.352 0 0.165
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 132.1 0 0 1
    translate 3.358 0 0.162
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 269.7 0 0 1
    translate 3.365 0 0.159
    scale 0.198 0.198 0.278
    object_flat generate:icosphere:80
pop_matrix
cr 0.90 0.60 0.24
push_matrix
    rotate 47.2 0 0 1
    translate 3.371 0 0.156
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 184.7 0 0 1
    translate 3.377 0 0.154
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 322.2 0 0 1
    translate 3.383 0 0.151
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 99.7 0 0 1
    translate 3.390 0 0.148
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 237.2 0 0 1
    translate 3.396 0 0.145
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 14.7 0 0 1
    translate 3.402 0 0.143
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 152.2 0 0 1
    translate 3.408 0 0.140
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 289.7 0 0 1
    translate 3.414 0 0.137
    scale 0.199 0.199 0.278
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 67.2 0 0 1
    translate 3.420 0 0.134
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 204.7 0 0 1
    translate 3.427 0 0.132
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
cr 0.90 0.61 0.25
push_matrix
    rotate 342.2 0 0 1
    translate 3.433 0 0.129
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 119.7 0 0 1
    translate 3.439 0 0.126
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 257.3 0 0 1
    translate 3.445 0 0.123
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 34.8 0 0 1
    translate 3.451 0 0.121
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 172.3 0 0 1
    translate 3.457 0 0.118
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 309.8 0 0 1
    translate 3.463 0 0.115
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 87.3 0 0 1
    translate 3.469 0 0.112
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 224.8 0 0 1
    translate 3.475 0 0.110
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 2.3 0 0 1
    translate 3.481 0 0.107
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 139.8 0 0 1
    translate 3.487 0 0.104
    scale 0.199 0.199 0.279
    object_flat generate:icosphere:80
pop_matrix
cr 0.90 0.63 0.27
push_matrix
    rotate 277.3 0 0 1
    translate 3.493 0 0.101
    scale 0.200 0.200 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 54.8 0 0 1
    translate 3.499 0 0.099
    scale 0.200 0.200 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 192.3 0 0 1
    translate 3.505 0 0.096
    scale 0.200 0.200 0.279
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 329.8 0 0 1
    translate 3.511 0 0.093
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 107.4 0 0 1
    translate 3.517 0 0.090
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 244.9 0 0 1
    translate 3.523 0 0.088
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 22.4 0 0 1
    translate 3.529 0 0.085
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 159.9 0 0 1
    translate 3.535 0 0.082
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 297.4 0 0 1
    translate 3.541 0 0.079
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 74.9 0 0 1
    translate 3.547 0 0.077
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
cr 0.91 0.65 0.29
push_matrix
    rotate 212.4 0 0 1
    translate 3.553 0 0.074
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 349.9 0 0 1
    translate 3.559 0 0.071
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 127.4 0 0 1
    translate 3.565 0 0.068
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 264.9 0 0 1
    translate 3.571 0 0.066
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 42.4 0 0 1
    translate 3.577 0 0.063
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 179.9 0 0 1
    translate 3.583 0 0.060
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 317.4 0 0 1
    translate 3.588 0 0.057
    scale 0.200 0.200 0.280
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 95.0 0 0 1
    translate 3.594 0 0.055
    scale 0.200 0.200 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 232.5 0 0 1
    translate 3.600 0 0.052
    scale 0.200 0.200 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 10.0 0 0 1
    translate 3.606 0 0.049
    scale 0.200 0.200 0.281
    object_flat generate:icosphere:80
pop_matrix
cr 0.91 0.67 0.31
push_matrix
    rotate 147.5 0 0 1
    translate 3.612 0 0.046
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 285.0 0 0 1
    translate 3.618 0 0.044
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 62.5 0 0 1
    translate 3.623 0 0.041
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 200.0 0 0 1
    translate 3.629 0 0.038
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 337.5 0 0 1
    translate 3.635 0 0.035
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 115.0 0 0 1
    translate 3.641 0 0.033
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 252.5 0 0 1
    translate 3.646 0 0.030
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 30.0 0 0 1
    translate 3.652 0 0.027
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 167.5 0 0 1
    translate 3.658 0 0.024
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 305.1 0 0 1
    translate 3.664 0 0.022
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
cr 0.91 0.69 0.33
push_matrix
    rotate 82.6 0 0 1
    translate 3.669 0 0.019
    scale 0.201 0.201 0.281
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 220.1 0 0 1
    translate 3.675 0 0.016
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 357.6 0 0 1
    translate 3.681 0 0.013
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 135.1 0 0 1
    translate 3.687 0 0.011
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 272.6 0 0 1
    translate 3.692 0 0.008
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 50.1 0 0 1
    translate 3.698 0 0.005
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 187.6 0 0 1
    translate 3.704 0 0.002
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 325.1 0 0 1
    translate 3.709 0 -0.000
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 102.6 0 0 1
    translate 3.715 0 -0.003
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 240.1 0 0 1
    translate 3.721 0 -0.006
    scale 0.201 0.201 0.282
    object_flat generate:icosphere:80
pop_matrix
cr 0.92 0.71 0.35
push_matrix
    rotate 17.6 0 0 1
    translate 3.726 0 -0.009
    scale 0.202 0.202 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 155.1 0 0 1
    translate 3.732 0 -0.011
    scale 0.202 0.202 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 292.7 0 0 1
    translate 3.738 0 -0.014
    scale 0.202 0.202 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 70.2 0 0 1
    translate 3.743 0 -0.017
    scale 0.202 0.202 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 207.7 0 0 1
    translate 3.749 0 -0.020
    scale 0.202 0.202 0.282
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 345.2 0 0 1
    translate 3.754 0 -0.022
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 122.7 0 0 1
    translate 3.760 0 -0.025
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 260.2 0 0 1
    translate 3.766 0 -0.028
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 37.7 0 0 1
    translate 3.771 0 -0.031
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 175.2 0 0 1
    translate 3.777 0 -0.033
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
cr 0.92 0.73 0.37
push_matrix
    rotate 312.7 0 0 1
    translate 3.782 0 -0.036
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 90.2 0 0 1
    translate 3.788 0 -0.039
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 227.7 0 0 1
    translate 3.793 0 -0.042
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 5.2 0 0 1
    translate 3.799 0 -0.044
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 142.8 0 0 1
    translate 3.804 0 -0.047
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 280.3 0 0 1
    translate 3.810 0 -0.050
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 57.8 0 0 1
    translate 3.815 0 -0.053
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 195.3 0 0 1
    translate 3.821 0 -0.055
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 332.8 0 0 1
    translate 3.826 0 -0.058
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 110.3 0 0 1
    translate 3.832 0 -0.061
    scale 0.202 0.202 0.283
    object_flat generate:icosphere:80
pop_matrix
cr 0.92 0.75 0.39
push_matrix
    rotate 247.8 0 0 1
    translate 3.837 0 -0.064
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 25.3 0 0 1
    translate 3.843 0 -0.066
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 162.8 0 0 1
    translate 3.848 0 -0.069
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 300.3 0 0 1
    translate 3.854 0 -0.072
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 77.8 0 0 1
    translate 3.859 0 -0.075
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 215.3 0 0 1
    translate 3.865 0 -0.077
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 352.8 0 0 1
    translate 3.870 0 -0.080
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 130.4 0 0 1
    translate 3.876 0 -0.083
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 267.9 0 0 1
    translate 3.881 0 -0.086
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 45.4 0 0 1
    translate 3.886 0 -0.088
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
cr 0.93 0.77 0.41
push_matrix
    rotate 182.9 0 0 1
    translate 3.892 0 -0.091
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 320.4 0 0 1
    translate 3.897 0 -0.094
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 97.9 0 0 1
    translate 3.903 0 -0.097
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 235.4 0 0 1
    translate 3.908 0 -0.099
    scale 0.203 0.203 0.284
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 12.9 0 0 1
    translate 3.913 0 -0.102
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 150.4 0 0 1
    translate 3.919 0 -0.105
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 287.9 0 0 1
    translate 3.924 0 -0.108
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 65.4 0 0 1
    translate 3.929 0 -0.110
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 202.9 0 0 1
    translate 3.935 0 -0.113
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 340.5 0 0 1
    translate 3.940 0 -0.116
    scale 0.203 0.203 0.285
    object_flat generate:icosphere:80
pop_matrix
cr 0.93 0.79 0.43
push_matrix
    rotate 118.0 0 0 1
    translate 3.945 0 -0.119
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 255.5 0 0 1
    translate 3.951 0 -0.121
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 33.0 0 0 1
    translate 3.956 0 -0.124
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 170.5 0 0 1
    translate 3.961 0 -0.127
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 308.0 0 0 1
    translate 3.967 0 -0.130
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 85.5 0 0 1
    translate 3.972 0 -0.132
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 223.0 0 0 1
    translate 3.977 0 -0.135
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 0.5 0 0 1
    translate 3.982 0 -0.138
    scale 0.204 0.204 0.285
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 138.0 0 0 1
    translate 3.988 0 -0.141
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 275.5 0 0 1
    translate 3.993 0 -0.143
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
cr 0.93 0.80 0.44
push_matrix
    rotate 53.0 0 0 1
    translate 3.998 0 -0.146
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 190.5 0 0 1
    translate 4.004 0 -0.149
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 328.1 0 0 1
    translate 4.009 0 -0.152
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 105.6 0 0 1
    translate 4.014 0 -0.154
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 243.1 0 0 1
    translate 4.019 0 -0.157
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 20.6 0 0 1
    translate 4.024 0 -0.160
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 158.1 0 0 1
    translate 4.030 0 -0.163
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 295.6 0 0 1
    translate 4.035 0 -0.165
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 73.1 0 0 1
    translate 4.040 0 -0.168
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 210.6 0 0 1
    translate 4.045 0 -0.171
    scale 0.204 0.204 0.286
    object_flat generate:icosphere:80
pop_matrix
cr 0.94 0.82 0.46
push_matrix
    rotate 348.1 0 0 1
    translate 4.051 0 -0.174
    scale 0.205 0.205 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 125.6 0 0 1
    translate 4.056 0 -0.176
    scale 0.205 0.205 0.286
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 263.1 0 0 1
    translate 4.061 0 -0.179
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 40.6 0 0 1
    translate 4.066 0 -0.182
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 178.2 0 0 1
    translate 4.071 0 -0.185
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 315.7 0 0 1
    translate 4.076 0 -0.187
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 93.2 0 0 1
    translate 4.082 0 -0.190
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 230.7 0 0 1
    translate 4.087 0 -0.193
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 8.2 0 0 1
    translate 4.092 0 -0.196
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
push_matrix
    rotate 145.7 0 0 1
    translate 4.097 0 -0.198
    scale 0.205 0.205 0.287
    object_flat generate:icosphere:80
pop_matrix
end
